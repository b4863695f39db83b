"""``wireprint studio`` as a process."""

import http.client
import os
import re
import signal
import socket
import subprocess
import sys
from pathlib import Path

import pytest

from command import run

pytest.importorskip("starlette")
pytest.importorskip("uvicorn")

COMMAND = [sys.executable, "-c", "from wireprint.cli import main; main()", "studio"]


@pytest.fixture
def opened(cube):
    """A window's process, its port and token."""
    process = subprocess.Popen(
        [*COMMAND, str(cube), "--no-browser", "--port", "0"],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        # A shell's background jobs inherit that it is ignored.
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),
    )
    try:
        found = re.fullmatch(
            r"http://127\.0\.0\.1:(\d+)/\?token=([\w-]{32})\n", process.stdout.readline()
        )
        yield process, int(found[1]), found[2]
    finally:
        process.kill()
        process.wait()
        process.stdout.close()
        process.stderr.close()


def asked(port, method, path, headers=(), body=b""):
    """Send what no client would, and return the status."""
    lines = [
        f"{method} {path} HTTP/1.1",
        f"Content-Length: {len(body)}",
        "Connection: close",
        *headers,
    ]
    with socket.create_connection(("127.0.0.1", port)) as line:
        line.sendall(("\r\n".join(lines) + "\r\n\r\n").encode() + body)
        answer = http.client.HTTPResponse(line)
        answer.begin()
        answer.read()
        return answer.status, answer.headers


def test_only_this_machine_is_listened_to(opened):
    _, port, _ = opened
    if not Path("/proc/net/tcp").exists():
        pytest.skip("needs /proc/net/tcp")
    listening = [
        line.split()[1]
        for name in ("tcp", "tcp6")
        for line in Path("/proc/net", name).read_text().splitlines()[1:]
        if line.split()[3] == "0A" and line.split()[1].endswith(f":{port:04X}")
    ]
    assert listening == [f"0100007F:{port:04X}"]


def test_the_token_opens_the_page_and_is_nowhere_after(opened):
    process, port, token = opened
    host = f"Host: 127.0.0.1:{port}"
    status, headers = asked(port, "GET", f"/?token={token}", [host])
    assert status == 303
    assert token not in str(headers)
    cookie = f"Cookie: {headers['set-cookie'].partition(';')[0]}"
    assert asked(port, "GET", "/", [host, cookie])[0] == 200
    assert asked(port, "GET", "/", [host])[0] == 403
    assert asked(port, "GET", "/../../../etc/passwd", [host, cookie])[0] == 404
    assert asked(port, "GET", "/", ["Host: evil.example", cookie])[0] == 421
    assert asked(port, "GET", "/", [cookie])[0] in (400, 421)
    assert asked(port, "GET", "/", [host, host, cookie])[0] in (400, 421)
    assert (
        asked(port, "POST", "/message", [host, cookie, "Content-Type: text/plain"], b"{}")[0] == 400
    )
    process.send_signal(signal.SIGINT)
    out, errors = process.communicate(timeout=60)
    assert process.returncode == 0
    assert token not in out + errors
    assert errors == "closed\n"


def test_a_port_that_is_taken_is_a_usage_error(cube):
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        taken.listen()
        result = run("studio", cube, "--no-browser", "--port", taken.getsockname()[1])
    assert result.exit_code == 2
    assert "address already in use" in result.stderr


def test_settings_that_are_wrong_are_said_before_anything_opens(cube):
    result = run("studio", cube, "--no-browser", "--set", "wire.slab_max_mm=500")
    assert result.exit_code == 4
    assert "exceeds head.cone_height_mm" in result.stderr
    assert "http" not in result.stdout


def test_a_model_that_is_not_there_is_said(tmp_path):
    result = run("studio", tmp_path / "no.stl", "--no-browser")
    assert result.exit_code == 3


def test_without_the_extra_the_way_to_it_is_said(cube, monkeypatch):
    import importlib.util

    found = importlib.util.find_spec
    monkeypatch.setattr(
        importlib.util, "find_spec", lambda name: None if name == "uvicorn" else found(name)
    )
    result = run("studio", cube)
    assert result.exit_code == 2
    assert "pip install 'wireprint[studio]'" in result.stderr


def test_help_needs_no_server():
    code = (
        "import sys\nfrom wireprint.cli import main\n"
        "try: main(['studio', '--help'])\nexcept SystemExit: pass\n"
        "print(sorted({'starlette', 'uvicorn', 'numpy', 'pydantic'} & set(sys.modules)))"
    )
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, env=os.environ
    )
    assert done.stdout.rstrip().endswith("[]")
