"""Files sent to hosts: what each kind is asked, whose keys go where, and what failures say."""

import json
import os
import threading
import zlib
from urllib.parse import parse_qs, urlsplit

import pytest

from command import run
from fake_hosts import KEY, duet, fake_host, keep, parts_of
from wireprint import examples, hosts
from wireprint._core import SettingError
from wireprint.hosts import web
from wireprint.hosts.sending import plain_name, send
from wireprint.hosts.web import SendError

GCODE = b"G28\nG1 X1 Y1\n; \xc3\xa9\n"


@pytest.fixture
def server():
    with fake_host() as fake:
        yield fake


@pytest.fixture(autouse=True)
def home(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path / "config"))
    return tmp_path


def host_at(server, kind, key=KEY, storage="usb"):
    return hosts.Host("mine", kind, f"http://127.0.0.1:{server.server_port}", key, storage)


@pytest.mark.parametrize("start", [False, True])
def test_octoprint_takes_a_form_with_its_key(server, start):
    sent = send(host_at(server, "octoprint"), "a bottle.gcode", GCODE, start=start)
    ((method, path, headers, body),) = server.asked
    assert (method, path, headers["X-Api-Key"]) == ("POST", "/api/files/local", KEY)
    word = b"true" if start else b"false"
    assert parts_of(headers, body) == {
        "select": (None, word),
        "print": (None, word),
        "file": ("a_bottle.gcode", GCODE),
    }
    assert (sent.host, sent.file, sent.started) == ("mine", "a_bottle.gcode", start)


@pytest.mark.parametrize("key", [KEY, ""])
def test_moonraker_takes_a_form_with_or_without_a_key(server, key):
    send(host_at(server, "moonraker", key), "b.gcode", GCODE)
    ((method, path, headers, body),) = server.asked
    assert (method, path, headers.get("X-Api-Key", "")) == ("POST", "/server/files/upload", key)
    assert parts_of(headers, body) == {
        "root": (None, b"gcodes"),
        "print": (None, b"false"),
        "file": ("b.gcode", GCODE),
    }


def test_octoprint_that_starts_nothing_is_not_believed_to_print(server):
    # As OctoPrint 1.11 answers while no printer is connected.
    server.answers = lambda *_: (201, {"done": True, "effectivePrint": False}, {})
    send(host_at(server, "octoprint"), "b.gcode", GCODE)
    with pytest.raises(SendError, match="not started: is the printer connected"):
        send(host_at(server, "octoprint"), "b.gcode", GCODE, start=True)


def test_a_key_that_octoprint_does_not_know_is_called_so(server):
    # As OctoPrint 1.11 answers to a key that is nobody's.
    server.answers = lambda *_: (400, b"CSRF validation failed", {})
    with pytest.raises(SendError, match="it does not know the key"):
        send(host_at(server, "octoprint"), "b.gcode", GCODE)


def test_moonraker_that_starts_nothing_is_not_believed_to_print(server):
    server.answers = lambda *_: (201, {"print_started": False}, {})
    send(host_at(server, "moonraker"), "b.gcode", GCODE)
    with pytest.raises(SendError, match="the file is there, but was not started"):
        send(host_at(server, "moonraker"), "b.gcode", GCODE, start=True)


@pytest.mark.parametrize(("start", "storage"), [(False, "usb"), (True, "local")])
def test_prusalink_takes_the_text_itself(server, start, storage):
    send(host_at(server, "prusalink", storage=storage), "c.gcode", GCODE, start=start)
    ((method, path, headers, body),) = server.asked
    assert (method, path, body) == ("PUT", f"/api/v1/files/{storage}/c.gcode", GCODE)
    assert headers["X-Api-Key"] == KEY
    assert headers["Print-After-Upload"] == ("?1" if start else "?0")
    assert headers["Content-Length"] == str(len(GCODE))


@pytest.mark.parametrize("start", [False, True])
def test_a_duet_is_asked_within_a_session(server, start):
    server.answers = duet
    send(host_at(server, "duet"), "d.gcode", GCODE, start=start)
    paths = [urlsplit(path).path for _, path, _, _ in server.asked]
    started = ["/rr_gcode"] if start else []
    assert paths == ["/rr_connect", "/rr_upload", *started, "/rr_disconnect"]
    asked = parse_qs(urlsplit(server.asked[1][1]).query)
    assert asked["name"] == ["0:/gcodes/d.gcode"]
    assert asked["crc32"] == [f"{zlib.crc32(GCODE):08x}"]
    assert server.asked[1][3] == GCODE
    if start:
        command = parse_qs(urlsplit(server.asked[2][1]).query)["gcode"]
        assert command == ['M32 "0:/gcodes/d.gcode"']


def test_a_duet_with_another_password_says_so_without_it(server):
    server.answers = duet
    with pytest.raises(SendError, match="the password is wrong") as caught:
        send(host_at(server, "duet", "secret"), "d.gcode", GCODE)
    assert "secret" not in str(caught.value)


@pytest.mark.parametrize("kind", hosts.KINDS)
@pytest.mark.parametrize(
    ("code", "answer", "message"),
    [
        (401, {}, "the key is wrong"),
        (403, {"error": "nope"}, "may not do this; nope"),
        (404, b"<html>", "is it of this kind"),
        (409, {"error": {"message": "busy\x1b[2J"}}, r"it prints, .*; busy\\x1b\[2J|busy"),
        (413, {}, "too large"),
        (500, b"oh", r"refused \(500\): oh"),
        (302, {}, "it sends on to another address"),
    ],
)
def test_a_refusal_is_told_and_sends_the_key_nowhere_else(server, kind, code, answer, message):
    other = f"http://localhost:{server.server_port}/elsewhere"
    server.answers = lambda *_: (code, answer, {"Location": other} if code == 302 else {})
    with pytest.raises(SendError, match=message) as caught:
        send(host_at(server, kind), "e.gcode", GCODE)
    assert KEY not in str(caught.value)
    assert str(caught.value).isprintable()
    assert "/elsewhere" not in [path for _, path, _, _ in server.asked]


def test_a_host_that_is_not_there_is_told():
    nowhere = hosts.Host("mine", "octoprint", "http://127.0.0.1:9", KEY)
    with pytest.raises(SendError, match=r"mine \(http://127\.0\.0\.1:9\): not reached"):
        send(nowhere, "f.gcode", GCODE)


def test_a_host_that_is_silent_is_waited_for_no_longer(server):
    stop = threading.Event()
    server.answers = lambda *_: stop.wait(20) and (200, {}, {})
    try:
        with pytest.raises(SendError, match=r"no answer within 0\.2 s"):
            web.ask(host_at(server, "octoprint"), "GET", "/", timeout_s=0.2)
    finally:
        stop.set()


@pytest.mark.parametrize(
    ("given", "name"),
    [
        ("bottle.gcode", "bottle.gcode"),
        ("../../etc/passwd", "etc_passwd.gcode"),
        ('a"b\r\nc.gcode', "a_b_c.gcode"),
        ("é.g", "print.gcode"),
        ("x" * 300, "x" * 80 + ".gcode"),
        ("", "print.gcode"),
        ("part.GCO", "part.gcode"),
    ],
)
def test_names_mean_nothing_to_a_host(given, name):
    assert plain_name(given) == name


def test_hosts_are_read_from_the_users_own_file():
    keep(
        '[shop]\nkind = "octoprint"\nurl = "http://shop.local/"\nkey = "abc"\n\n'
        '[cellar]\nkind = "prusalink"\nurl = "https://10.0.0.4:84"\nkey = "k"\nstorage = "local"\n'
    )
    assert hosts.names() == ["cellar", "shop"]
    assert hosts.find("shop") == hosts.Host("shop", "octoprint", "http://shop.local", "abc")
    assert hosts.find("cellar").storage == "local"
    assert "abc" not in repr(hosts.find("shop"))


WRONG = {
    'kind = "octo"\nurl = "http://a"': r"hosts\.toml:2: a\.kind: 'octo' is none of octoprint",
    'kind = "duet"\nurl = "ftp://a"': r"hosts\.toml:3: a\.url: it must be like http",
    'kind = "duet"\nurl = "http://me:pw@a"': r"a\.url: it must be like",
    'kind = "duet"\nurl = "http://a:99999"': r"a\.url: it must be like",
    'kind = "octoprint"\nurl = "http://a"': r"a\.key: octoprint wants one",
    'kind = "duet"\nurl = "http://a"\nkey = "a\\nb"': r"hosts\.toml:4: a\.key: .* one line",
    'kind = "duet"\nurl = "http://a"\nkey = 3': r"a\.key: it must be one line",
    'kind = "duet"\nurl = "http://a"\npassword = "x"': r"hosts\.toml:4: a\.password: unknown",
    'kind = "prusalink"\nurl = "http://a"\nkey = "k"\nstorage = "x"': r"a\.storage: it must be usb",
}


@pytest.mark.parametrize("text", WRONG)
def test_a_wrong_entry_names_file_line_and_key(text):
    keep(f"[a]\n{text}\n")
    with pytest.raises(SettingError, match=WRONG[text]):
        hosts.find("a")


def test_a_host_that_is_not_known_is_told_with_those_that_are():
    assert hosts.names() == []
    with pytest.raises(SettingError, match=r"hosts\.toml: no such file; .*chmod 600"):
        hosts.find("shop")
    keep('[shop]\nkind = "duet"\nurl = "http://a"\n')
    with pytest.raises(SettingError, match="no host is called 'shopp'; did you mean shop"):
        hosts.find("shopp")


@pytest.mark.skipif(os.name != "posix", reason="other systems keep rights in another way")
@pytest.mark.parametrize("mode", [0o644, 0o640, 0o604, 0o660])
def test_keys_that_others_may_read_are_refused(mode):
    keep('[shop]\nkind = "duet"\nurl = "http://a"\n', mode)
    with pytest.raises(SettingError, match=rf"others than you may read it \({mode:o}\); chmod 600"):
        hosts.find("shop")


@pytest.fixture
def shop(server):
    keep(
        f'[shop]\nkind = "octoprint"\nkey = "{KEY}"\n'
        f'url = "http://127.0.0.1:{server.server_port}"\n'
    )
    return server


@pytest.fixture
def cube(home):
    path = home / "cube.stl"
    path.write_bytes(examples.stl("cube"))
    return path


def test_slice_sends_what_it_has_written(shop, cube):
    out = cube.with_name("cube.gcode")
    done = run("slice", str(cube), "-o", str(out), "--send", "shop", "--json")
    assert done.exit_code == 0, done.output
    assert json.loads(done.stdout)["sent"] == {
        "host": "shop",
        "file": "cube.gcode",
        "started": False,
    }
    ((_, _, headers, body),) = shop.asked
    found = parts_of(headers, body)
    assert found["file"] == ("cube.gcode", out.read_bytes())
    assert found["print"] == (None, b"false")
    assert KEY not in done.output


def test_slice_starts_a_print_only_where_it_is_told_to(shop, cube):
    out = cube.with_name("cube.gcode")
    done = run("slice", str(cube), "-o", str(out), "--send", "shop", "--start")
    assert done.exit_code == 0, done.output
    assert "sent        to shop, where cube.gcode is printed" in done.output
    ((_, _, headers, body),) = shop.asked
    assert parts_of(headers, body)["print"] == (None, b"true")


def test_what_is_not_certified_is_not_sent_unless_it_is_forced(shop, cube):
    out = cube.with_name("cube.gcode")
    wild = ["slice", str(cube), "-o", str(out), "--send", "shop"]
    wild += ["--set", 'gcode.end="M104 S0\\nG1 X0 Y0 Z5 F600"']
    assert run(*wild).exit_code == 5
    assert shop.asked == []
    assert not out.exists()
    assert run(*wild, "--force").exit_code == 0
    assert len(shop.asked) == 1


def test_a_host_that_refuses_leaves_the_file_here(shop, cube):
    shop.answers = lambda *_: (403, {}, {})
    out = cube.with_name("cube.gcode")
    done = run("slice", str(cube), "-o", str(out), "--send", "shop")
    assert done.exit_code == 6
    assert "the key is wrong" in done.output
    assert out.exists()


def test_wrong_usage_is_told_before_anything_is_sliced(shop, cube):
    out = str(cube.with_name("out"))
    assert run("slice", str(cube), "-o", f"{out}.gcode", "--start").exit_code == 2
    assert run("slice", str(cube), str(cube), "-o", out, "--send", "shop", "--start").exit_code == 2
    assert run("slice", str(cube), "-o", f"{out}.gcode", "--send", "nobody").exit_code == 4
    assert shop.asked == []
