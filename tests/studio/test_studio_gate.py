"""Who is let in: the window's own page, with the token, on this machine."""

import pytest

pytest.importorskip("starlette")

from starlette.testclient import TestClient
from starlette.websockets import WebSocketDisconnect

from wireprint.window.answer import decoded
from wireprint.window.gate import Gate
from wireprint.window.messages import MOST_BYTES
from wireprint.window.server import guarded

PORT = 43210
TOKEN = "a-token-that-nobody-guesses"
HERE = f"http://127.0.0.1:{PORT}"
TALK = f"ws://127.0.0.1:{PORT}/messages"
JSON = {"Content-Type": "application/json"}


def client_of(source):
    app = guarded(source, Gate(PORT, TOKEN))
    return TestClient(app, base_url=HERE, follow_redirects=False)


@pytest.fixture
def stranger(source):
    return client_of(source)


@pytest.fixture
def page(stranger):
    """A client that opened the address, and has the cookie."""
    with stranger:
        assert stranger.get(f"/?token={TOKEN}").status_code == 303
        yield stranger


FILES = ("/", "/studio.js", "/licences.txt")


@pytest.mark.parametrize("path", [*FILES, "/message", "/messages", "/no-such", "/?token=wrong"])
def test_without_the_token_nothing_is_given(stranger, path):
    assert stranger.get(path).status_code == 403
    assert stranger.post(path, json={"do": "open"}).status_code == 403


def test_the_token_is_exchanged_for_a_cookie_that_scripts_and_other_sites_do_not_have(stranger):
    answer = stranger.get(f"/?token={TOKEN}")
    assert answer.headers["location"] == "/"
    cookie = answer.headers["set-cookie"]
    assert cookie.startswith(f"wireprint-{PORT}=")
    assert {"httponly", "samesite=strict", "path=/"} <= {
        part.strip().lower() for part in cookie.split(";")
    }
    assert TOKEN not in cookie
    assert answer.headers["referrer-policy"] == "no-referrer"


@pytest.mark.parametrize(
    "given", ["", "a", TOKEN + "x", TOKEN[:-1], "ü", "%00", f"{TOKEN}&token=x"]
)
def test_another_token_is_none(stranger, given):
    assert stranger.get(f"/?token={given}").status_code == 403


def test_a_cookie_of_another_window_is_none(source, page):
    other = client_of(source)
    assert other.get("/", headers={"Cookie": f"wireprint-{PORT}={TOKEN}"}).status_code == 403
    pass_ = page.cookies[f"wireprint-{PORT}"]
    assert other.get("/", headers={"Cookie": f"wireprint-{PORT}={pass_}"}).status_code == 403
    assert other.get("/", headers={"Cookie": f"wireprint-1={pass_}"}).status_code == 403


@pytest.mark.parametrize("path", FILES)
def test_the_page_is_given_with_headers_that_keep_others_out(page, path):
    answer = page.get(path)
    assert answer.status_code == 200
    policy = answer.headers["content-security-policy"]
    assert policy.startswith("default-src 'self';")
    assert "frame-ancestors 'none'" in policy
    assert "unsafe" not in policy
    assert answer.headers["x-content-type-options"] == "nosniff"
    assert answer.headers["x-frame-options"] == "DENY"
    assert answer.headers["cache-control"] == "no-store"
    assert "server" not in answer.headers
    assert "access-control-allow-origin" not in answer.headers


@pytest.mark.parametrize(
    "host",
    [
        "evil.example",
        f"evil.example:{PORT}",
        "127.0.0.1",
        "127.0.0.1:1",
        f"127.0.0.1.evil:{PORT}",
        "",
    ],
)
def test_a_foreign_name_is_misdirected(page, host):
    assert page.get("/", headers={"Host": host}).status_code == 421
    assert page.get(f"/?token={TOKEN}", headers={"Host": host}).status_code == 421


def test_localhost_is_a_name_of_this_machine(page):
    assert page.get("/", headers={"Host": f"localhost:{PORT}"}).status_code == 200


@pytest.mark.parametrize(
    "origin", ["http://evil.example", "null", f"https://127.0.0.1:{PORT}", "http://127.0.0.1:1", ""]
)
def test_another_page_is_not_answered(page, origin):
    headers = {"Origin": origin}
    assert page.get("/", headers=headers).status_code == 403
    assert (
        page.post("/message", headers=JSON | headers, content=b'{"do":"undo"}').status_code == 403
    )
    with (
        pytest.raises(WebSocketDisconnect),
        page.websocket_connect(TALK, headers=headers),
    ):
        pass


def test_a_websocket_without_the_cookie_is_refused(stranger):
    with (
        pytest.raises(WebSocketDisconnect),
        stranger.websocket_connect(TALK),
    ):
        pass


@pytest.mark.parametrize(
    "kind", ["text/plain", "application/x-www-form-urlencoded", "multipart/form-data", ""]
)
def test_a_form_is_no_message(page, kind):
    answer = page.post("/message", headers={"Content-Type": kind}, content=b'{"do":"undo"}')
    assert answer.status_code == 400


def test_what_is_too_long_is_refused(page):
    long = page.post("/message", headers=JSON, content=b" " * (MOST_BYTES + 1))
    assert long.status_code == 400
    endless = page.post("/message", headers=JSON, content=iter([b"{}"]))
    assert endless.status_code == 400


@pytest.mark.parametrize(
    "path",
    [
        "/../server.py",
        "/..%2fserver.py",
        "/static/studio.js",
        "/%2e%2e/server.py",
        "//etc/passwd",
        "/studio.js/",
    ],
)
def test_nothing_but_the_pages_files_is_there(page, path):
    assert page.get(path).status_code == 404


@pytest.mark.parametrize("method", ["PUT", "DELETE", "PATCH", "OPTIONS"])
def test_other_methods_are_not_known(page, method):
    for path in ("/", "/message"):
        assert page.request(method, path).status_code == 405


def test_a_message_by_post_is_answered(page):
    answer = page.post("/message", headers=JSON, content=b'{"do":"open","id":3}')
    assert decoded(answer.content)[0]["event"] == "welcome"


def test_a_page_is_told_the_model_its_print_and_the_answer_to_a_mark(page):
    with page.websocket_connect(TALK, headers={"Origin": HERE}) as socket:
        assert decoded(socket.receive_bytes())[0]["event"] == "welcome"
        seen = set()
        while "print" not in seen:
            seen.add(decoded(socket.receive_bytes())[0]["event"])
        assert {"model", "state"} <= seen
        socket.send_text(
            '{"do":"mark","id":9,"mark":{"shape":{"kind":"z","low_mm":9,"high_mm":12}}}'
        )
        heads = []
        while not any(head.get("event") == "current" and head["revision"] == 1 for head in heads):
            heads.append(decoded(socket.receive_bytes())[0])
        assert {"re": 9, "number": 1, "revision": 1} in heads


def test_two_windows_see_the_same(page):
    with page.websocket_connect(TALK, headers={"Origin": HERE}) as one:
        while decoded(one.receive_bytes())[0]["event"] != "print":
            pass
        with page.websocket_connect(TALK, headers={"Origin": HERE}) as other:
            one.send_text('{"do":"mark","mark":{"shape":{"kind":"z","low_mm":9}}}')
            while len(decoded(other.receive_bytes())[0].get("items", [])) != 1:
                pass
