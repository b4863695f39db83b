"""Hosts that are none: they keep what they are asked, and answer as a test says."""

import json
import re
import threading
from contextlib import contextmanager
from email.parser import BytesParser
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from urllib.parse import parse_qs, urlsplit

from wireprint import hosts

KEY = "0123456789ABCDEF"


class Fake(BaseHTTPRequestHandler):
    """A host that keeps what it is asked; `answers` says what it answers."""

    def handle_any(self):
        length = int(self.headers.get("Content-Length") or 0)
        body = self.rfile.read(length)
        self.server.asked.append((self.command, self.path, dict(self.headers), body))
        code, answer, headers = self.server.answers(self.command, self.path, self.headers)
        self.send_response(code)
        for name, value in headers.items():
            self.send_header(name, value)
        self.end_headers()
        self.wfile.write(answer if isinstance(answer, bytes) else json.dumps(answer).encode())

    do_GET = do_POST = do_PUT = handle_any  # noqa: N815

    def log_message(self, *_):
        pass


@contextmanager
def fake_host():
    """A fake host on this machine; `answers` is set by the test."""
    fake = ThreadingHTTPServer(("127.0.0.1", 0), Fake)
    fake.asked = []
    fake.answers = lambda *_: (201, {"done": True}, {})
    thread = threading.Thread(target=fake.serve_forever, args=(0.02,))
    thread.start()
    yield fake
    fake.shutdown()
    thread.join()
    fake.server_close()


def keep(text, mode=0o600):
    file = hosts.path()
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(text, encoding="utf-8")
    file.chmod(mode)
    return file


def parts_of(headers, body):
    """The entries of a form: name → file's name and content."""
    head = f"Content-Type: {headers['Content-Type']}\r\n\r\n".encode()
    message = BytesParser().parsebytes(head + body)
    found = {}
    for part in message.get_payload():
        told = part["Content-Disposition"]
        name = re.search(r' name="([^"]*)"', told)[1]
        file = re.search(r'filename="([^"]*)"', told)
        found[name] = (file and file[1], part.get_payload(decode=True))
    return found


def duet(method, path, headers):
    if path.startswith("/rr_connect"):
        good = parse_qs(urlsplit(path).query)["password"] == [KEY]
        return 200, {"err": 0 if good else 1, "sessionKey": 77}, {}
    if headers.get("X-Session-Key") != "77":
        return 401, {}, {}
    return 200, {"err": 0}, {}
