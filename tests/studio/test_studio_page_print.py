"""What the page does with a print besides showing it: it sends it, and colours its forecast."""

import pytest
from studio_page import Window, settled, until

from fake_hosts import KEY, fake_host, keep


@pytest.fixture
def server(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path / "config"))
    with fake_host() as fake:
        url = f"http://127.0.0.1:{fake.server_port}"
        keep(f'[shop]\nkind = "octoprint"\nurl = "{url}"\nkey = "{KEY}"')
        yield fake


@pytest.fixture
def page(browser, cube, server):
    window = Window(browser, cube)
    yield window.page()
    window.close()


def test_a_print_is_started_by_a_second_click_alone(page, server):
    settled(page)
    page.get_by_label("more to export").click()
    page.get_by_role("menuitem", name="Send to a printer").click()
    dialog = page.get_by_role("dialog")
    assert "shop" in dialog.inner_text()
    dialog.get_by_role("button", name="Send", exact=True).click()
    dialog.get_by_text("cube.gcode is at shop").wait_for()
    assert len(server.asked) == 1
    assert b'name="print"\r\n\r\nfalse' in server.asked[0][3]
    dialog.get_by_role("button", name="Send and print").click()
    dialog.get_by_role("button", name="Start printing").wait_for()
    words = dialog.inner_text()
    for told in ("Print on shop now?", "cube.gcode", "kossel-mini", "keeps all rules"):
        assert told in words
    assert len(server.asked) == 1
    dialog.get_by_role("button", name="Start printing").click()
    dialog.get_by_text("which prints it").wait_for()
    assert b'name="print"\r\n\r\ntrue' in server.asked[1][3]
    assert KEY not in page.content()
    assert KEY not in page.evaluate("JSON.stringify(store.welcome.value)")
    # Keys of the window rest while the dialog is open, and Escape closes it.
    page.keyboard.press("b")
    assert page.evaluate("store.tool.value") == "turn"
    page.keyboard.press("Escape")
    until(page, "store.dialog.value === null")


def test_strands_are_coloured_by_what_is_forecast_of_them(page):
    settled(page)
    kinds = page.evaluate(
        "Array.from(document.querySelector('[aria-label=\"colour by\"]').options, (o) => o.value)"
    )
    assert {"sag", "compliance", "flow", "weld"} <= set(kinds)
    page.get_by_label("colour by").select_option("flow")
    until(page, "store.forecast.value !== null")
    page.get_by_text("no part of the certificate").wait_for()
    shares = page.evaluate(
        "Array.from(studio.view.strands.material.uniforms.values.value.image.data)"
        ".slice(0, store.strandCount.value)"
    )
    assert max(shares) > 0
    # The next print is forecast, too.
    page.evaluate("void studio.shape('z')")
    until(page, "store.state.value.items.length === 1")
    settled(page)
    until(page, "store.forecast.value?.revision === store.printed.value")
