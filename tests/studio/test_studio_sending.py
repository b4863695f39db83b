"""Prints that the window sends: the very bytes, to named hosts alone, and none started unasked."""

import threading

import pytest
from studio_talk import Talk, source_of

from fake_hosts import KEY, duet, fake_host, keep, parts_of
from wireprint import examples
from wireprint.window.answer import decoded


@pytest.fixture
def config(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path / "config"))


@pytest.fixture
def server(config):
    """A fake host, which the user's file calls ``shop`` with each kind's own name after it."""
    with fake_host() as fake:
        url = f"http://127.0.0.1:{fake.server_port}"
        kinds = ("octoprint", "moonraker", "prusalink", "duet")
        keep(
            "\n".join(
                f'[shop-{kind}]\nkind = "{kind}"\nurl = "{url}"\nkey = "{KEY}"' for kind in kinds
            )
        )
        fake.url = url
        yield fake


def over(talk):
    """Wait until a file was sent, or was not; return what is told of it."""
    return talk.wait("sending", lambda one: one["share"] is None)[0]


def sent_to(server, kind):
    """What a fake host of a kind was given: name, bytes, whether to start, key."""
    (asked,) = [one for one in server.asked if one[0] != "GET"]
    _, path, headers, body = asked
    if kind == "prusalink":
        started = headers["Print-After-Upload"] == "?1"
        return path.rpartition("/")[2], body, started, headers["X-Api-Key"]
    if kind == "duet":
        started = any("M32" in path for _, path, _, _ in server.asked)
        return path.partition("%2Fgcodes%2F")[2].partition("&")[0], body, started, KEY
    parts = parts_of(headers, body)
    return *parts["file"], parts["print"][1] == b"true", headers["X-Api-Key"]


@pytest.mark.parametrize("kind", ["octoprint", "moonraker", "prusalink", "duet"])
def test_a_host_gets_the_bytes_that_are_exported_and_starts_only_what_was_agreed_to(
    server, talk, kind
):
    if kind == "duet":
        server.answers = duet
    answer, _ = talk.ask("send", host=f"shop-{kind}")
    assert answer["file"] == "cube.gcode"
    assert over(talk)["error"] == ""
    assert sent_to(server, kind) == ("cube.gcode", talk.gcode(), False, KEY)

    server.asked.clear()
    talk.told.clear()
    asked, _ = talk.ask("send", host=f"shop-{kind}", start=True)
    assert asked["asks"]
    assert asked["file"] == "cube.gcode"
    assert server.asked == []
    answer, _ = talk.ask("send", host=f"shop-{kind}", start=True, sure=asked["asks"])
    assert answer["asks"] is None
    assert over(talk)["start"]
    assert sent_to(server, kind) == ("cube.gcode", talk.gcode(), True, KEY)


def test_a_start_that_was_agreed_to_is_not_one_of_another_print(server, talk):
    asked, _ = talk.ask("send", host="shop-octoprint", start=True)
    talk.edit("mark", mark={"shape": {"kind": "z", "low_mm": 5, "high_mm": 10}})
    again, _ = talk.ask("send", host="shop-octoprint", start=True, sure=asked["asks"])
    assert again["asks"] not in (None, asked["asks"])
    assert server.asked == []


def test_names_of_hosts_are_all_that_a_page_is_told(server, talk):
    server.answers = lambda *_: (403, {"error": f"no {KEY} for {server.url}"}, {})
    welcome = talk.session.welcome()[0]
    assert decoded(welcome)[0]["hosts"] == [
        f"shop-{kind}" for kind in ("duet", "moonraker", "octoprint", "prusalink")
    ]
    talk.ask("send", host="shop-octoprint")
    assert "shop-octoprint: refused (403)" in over(talk)["error"]
    told = b"".join([welcome, *(content for _, content in talk.told)])
    assert KEY.encode() not in told
    assert server.url.encode() not in told


def test_no_hosts_and_a_file_that_others_may_read_are_told(config, source):
    with Talk(source) as talk:
        assert decoded(talk.session.welcome()[0])[0]["hosts"] == []
        keep('[a]\nkind = "octoprint"\nurl = "http://a"\nkey = "k"', mode=0o644)
        welcome = decoded(talk.session.welcome()[0])[0]
        assert welcome["hosts"] == []
        assert "chmod 600" in welcome["hosts_fault"]
        assert "chmod 600" in talk.ask("send", host="a")[0]["error"]


@pytest.mark.parametrize("host", ["http://127.0.0.1:1", "shop", "", "../shop-duet"])
def test_a_page_gives_names_and_no_addresses(server, talk, host):
    assert "no host is called" in talk.ask("send", host=host)[0]["error"]
    assert server.asked == []


def test_a_host_that_is_not_there_is_told_in_words(server, talk):
    keep('[gone]\nkind = "moonraker"\nurl = "http://127.0.0.1:9"')
    talk.ask("send", host="gone")
    assert over(talk)["error"].startswith("gone: not reached: ")


def test_what_slice_refuses_is_not_sent(server, tmp_path):
    path = tmp_path / "sphere.stl"
    path.write_bytes(examples.stl("sphere"))
    with Talk(
        source_of(path, overrides=["wire.coverage_within_mm=0.5", "wire.coverage_goal=0"])
    ) as talk:
        head, _ = talk.ask("send", host="shop-octoprint")
        assert "outer surface would be covered" in head["error"]
        assert "export it" in head["error"]
    assert server.asked == []


def test_the_window_goes_on_while_a_file_is_on_its_way(server, talk):
    """And tells how far it is; a second one waits its turn."""
    arrived, answer = threading.Event(), threading.Event()

    def slow(*_):
        arrived.set()
        answer.wait(60)
        return 201, {}, {}

    server.answers = slow
    talk.ask("send", host="shop-octoprint")
    assert arrived.wait(60)
    talk.edit("mark", mark={"shape": {"kind": "z", "low_mm": 5, "high_mm": 10}})
    again, _ = talk.ask("send", host="shop-moonraker")
    assert "on its way to shop-octoprint" in again["error"]
    answer.set()
    assert over(talk)["error"] == ""
    shares = [decoded(content)[0]["share"] for name, content in talk.told if name == "sending"]
    assert shares[0] == 0
    assert shares[-1] is None
    assert shares[:-1] == sorted(shares[:-1])
    assert shares[-2] == 1


@pytest.mark.parametrize(
    "headers",
    [{"Origin": "http://evil.example"}, {"Host": "evil.example"}, {"Content-Type": "text/plain"}],
)
def test_nobody_but_the_window_has_a_print_sent(server, source, headers):
    pytest.importorskip("starlette")
    from starlette.testclient import TestClient

    from wireprint.window.gate import Gate
    from wireprint.window.server import guarded

    app = guarded(source, Gate(4321, "token"))
    message = b'{"do":"send","host":"shop-octoprint"}'
    plain = {"Content-Type": "application/json"}
    with TestClient(app, base_url="http://127.0.0.1:4321", follow_redirects=False) as page:
        assert page.post("/message", headers=plain, content=message).status_code == 403
        page.get("/?token=token")
        answer = page.post("/message", headers=plain | headers, content=message)
        assert 400 <= answer.status_code < 500
        assert server.asked == []
