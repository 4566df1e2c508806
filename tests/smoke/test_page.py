"""The interactive page in a real browser, held against the result files."""

import shutil
from pathlib import Path

import numpy as np
import pytest
import xarray as xr

SMOKE = ("--configfile", "config/config.yaml", "config/smoke.yaml")


@pytest.fixture(scope="module")
def page(smoke_run):
    """The page of the small study."""
    run = smoke_run.snakemake("-j2", "page", *SMOKE)
    assert run.returncode == 0, run.stdout[-20000:]
    return smoke_run.folder / "results" / "page.html"


@pytest.fixture(params=[(1200, 900), (390, 800)], ids=["desk", "phone"])
def opened(request, browser, page, tmp_path):
    """The page by itself in another folder, as it is handed on, in windows of two sizes."""
    alone = shutil.copy(page, tmp_path / "page.html")
    browser.errors.clear()
    browser.requests.clear()
    browser.open(Path(alone).as_uri(), *request.param)
    yield browser
    assert not browser.errors
    assert {address.split("#")[0] for address in browser.requests} <= {"about:blank", Path(alone).as_uri()}


def shown(browser):
    """Return the motion on the screen, its arrays as lists."""
    return browser.run(
        "Object.fromEntries(Object.entries(shown).map(([name, value]) => [name, ArrayBuffer.isView(value) ? [...value]"
        " : name === 'section' ? value.map((part) => [...part]) : value]))"
    )


def point_on_screen(browser, i):
    """Return where to click for the point i of the sweep."""
    browser.run("window.scrollTo(0, 0)")
    box = browser.run("JSON.parse(JSON.stringify(at('diagram').getBoundingClientRect()))")
    return box["left"] + browser.run(f"across(sweeps[chosen].value[{i}])"), box["top"] + 80


def test_the_first_view_shows_a_motion_and_fits_the_window(opened):
    assert opened.run("at('said').textContent").startswith("Case “without”")
    for panel in ("diagram", "section", "portrait", "force", "spectrum"):
        assert opened.run(f"at('{panel}').querySelectorAll('path[d]').length") > 5, panel
    assert opened.run("document.documentElement.scrollWidth <= innerWidth")


def test_a_click_shows_the_numbers_of_the_result_files(opened, page):
    results = page.parent
    opened.run("at('choice').value = sweeps.findIndex(({sweep}) => sweep === 'ste')")
    opened.run("at('choice').dispatchEvent(new Event('change'))")
    sweep = xr.open_dataset(results / "with" / "sweeps" / "restart" / "ste.nc").sortby("ste")
    motions = xr.open_dataset(results / "with" / "motions" / "restart" / "ste.nc").sortby("ste")
    drawn = set()
    for i in (1, sweep.sizes["point"] // 2, sweep.sizes["point"] - 2):
        opened.click(*point_on_screen(opened, i))
        point, orbit, now = sweep.isel(point=i), motions.isel(point=i), shown(opened)
        assert now["value"] == pytest.approx(float(point["ste"]), rel=1e-6)
        assert now["period"] == int(point["period"])
        assert now["exponent"] == pytest.approx(float(point["lyapunov_exponent"]), rel=1e-6)
        assert now["loss"] == pytest.approx(float(point["contact_loss_share"]), rel=1e-6, abs=1e-12)
        assert now["peak"] == pytest.approx(float(point["force_max"]), rel=1e-6)
        dots = int(point["period"]) or point.sizes["sample"]
        for found, name in zip(now["section"], ("displacement", "velocity"), strict=True):
            expected = point[f"section_{name}"].values[:dots]
            values = sweep[f"section_{name}"]
            np.testing.assert_allclose(found, expected, atol=float(values.max() - values.min()) / 6e4)
        for name in ("displacement", "velocity", "force"):
            expected = orbit[f"orbit_{name}"].dropna("time").values
            np.testing.assert_allclose(now[name], expected, atol=np.nanmax(motions[f"orbit_{name}"]) / 2e4)
        # the peak that the sweep recorded, of all times, and the top of the force on the screen, of 128 a period
        if now["period"]:
            assert 0.97 * now["peak"] < max(now["force"]) <= 1.001 * now["peak"]
        said = opened.run("at('said').textContent")
        assert f"{now['peak']:.4g} times the mean" in said and "Case “with”" in said
        drawn.add(opened.run("at('force').innerHTML + at('spectrum').innerHTML + at('portrait').innerHTML"))
    assert len(drawn) == 3


def test_keys_walk_along_the_sweep_and_the_address_keeps_the_point(opened, page):
    opened.run("at('diagram').focus()")
    opened.press("Home")
    opened.press("ArrowRight")
    opened.press("ArrowRight")
    opened.press("ArrowLeft")
    assert opened.run("point") == 1 and opened.run("at('diagram').getAttribute('aria-valuenow')") == "1"
    opened.press("End")
    assert opened.run("point === sweeps[chosen].value.length - 1")
    address = opened.run("location.href")
    assert address.endswith(f"#without/mesh_frequency/{opened.run('point')}")
    said = opened.run("at('said').textContent")
    opened.open(address, 1000, 700)
    assert opened.run("at('said').textContent") == said
