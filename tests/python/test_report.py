"""The page that wrcontact.report writes."""
import hashlib
import re
import subprocess

import numpy as np
import pytest

import wrcontact
from conftest import BUILD, PROJECT
from wrcontact.report import _origin, _write_whole, limits_of, verdict

MEASURED = PROJECT / "tests/reference/profiles/Car7216_0001r.txt"
pytest.importorskip("matplotlib")


def cells_of(page, heading):
    """Texts of the cells of the first table below a heading."""
    part = page.partition(f"<h2>{heading}</h2>")[2].partition("</table>")[0]
    return [re.findall(r"<t[hd][^>]*>([^<]*)", row) for row in part.split("<tr>")[1:]]


def test_a_report_has_what_its_profiles_and_scenes_have(tmp_path):
    wheel = wrcontact.Profile.from_file(MEASURED, kind="wheel")
    table = tmp_path / "limits.csv"
    table.write_text("quantity,least,greatest,source\nflange_height,26,36,here\nqr,20,,here\n"
                     "equivalent_conicity,,0.08,here\npmax_centred,,9000,here\n", encoding="utf-8")
    path = wrcontact.report(wheel, "60E1", tmp_path / "r.html", nominal_wheel="S1002", limits=table, load_both=60e3)
    page = path.read_text(encoding="utf-8")
    assert hashlib.sha256(MEASURED.read_bytes()).hexdigest() in page and "rail: 60E1, built in" in page
    assert re.search(r"<p>\d{4}-\d\d-\d\d \d\d:\d\d [+-]\d{4}, wrcontact \d+\.\d+\.\d+, by wrcontact.report in Python: load_both = 60000", page)
    assert not re.search('(src|href)="(?!data:)', page) and "<script" not in page
    verdicts = {row[0].partition(":")[0]: row[1] for row in cells_of(page, "Limits")[1:]}
    assert verdicts == {"flange height Sh": "pass", "qR": "fail", "equivalent conicity at an amplitude of 3 mm":
                        "pass, within its spread of the limit", "largest pressure, centred": "pass"}
    conicity = wheel.conicity("60E1")
    row = next(row for row in cells_of(page, "Equivalent conicity") if row[0] == "3")
    assert row[1:3] == [f"{conicity.value:.4f}", f"{np.interp(3, conicity.amplitude, conicity.spread):.4f}"]
    own, nominal = wheel.dimensions["flange_height"], wrcontact.Profile("S1002").dimensions["flange_height"]
    row = next(row for row in cells_of(page, "Wheel Car7216_0001r") if row[0].startswith("flange height"))
    assert row[1:4] == [f"{own:.3f}", f"{nominal:.3f}", f"{own - nominal:.3f}"]
    with np.testing.suppress_warnings() as quiet:
        quiet.filter(wrcontact.ContactWarning)
        centre = wrcontact.solve(wheel=wheel, rail="60E1", load_both=60e3, accuracy=1e-2)
    (row,) = [row for row in cells_of(page, "Centred on the track") if row[0] == "left pmax"]
    assert row[2:5] == [f"{value:.0f}" for value in (centre.left.pmax, centre["left.smoothed_0mm.pmax"], centre["left.smoothed_3mm.pmax"])]
    assert page.count("<img ") == 6
    row = next(row for row in cells_of(page, "Left wheel over the lateral position") if row[0] == "0.0")
    assert row[3] == f"{centre.left.angle:.4f}" != f"{centre.left.rigid_contact.angle:.4f}"


def test_the_uncertainty_by_noise_is_told_as_by_wrc_case(tmp_path):
    keys = {"load_both": 60e3, "accuracy": 0.1}
    page = wrcontact.report(str(MEASURED), "60E1", tmp_path / "r.html", **keys).read_text(encoding="utf-8")
    answer = subprocess.run([BUILD / "bin/wrc_case", "--set", f"wheelset.wheel={MEASURED}", "track.rail=60E1", "load.both=60000",
                             "solve.accuracy=0.1"], check=True, capture_output=True, text=True).stdout
    told = [line.partition("Do not use: ")[2] for line in answer.splitlines() if "uncertain by noise" in line]
    assert len(told) == 2 and all(f"<li>Do not use: {text}</li>" in page for text in told)


def test_a_file_that_is_read_is_not_overwritten(tmp_path, monkeypatch):
    monkeypatch.setattr(wrcontact.Profile, "conicity", lambda *_, **__: pytest.fail("solves before it refuses"))
    names = ["wheel.txt", "rail.txt", "limits.csv", "wheel0.txt"]
    for name, source in zip(names, ("S1002", "60E1", None, "S1002")):
        (tmp_path / name).write_text("", encoding="utf-8") if source is None else wrcontact.Profile(source).write(tmp_path / name)
    monkeypatch.chdir(tmp_path)
    (tmp_path / "link.txt").symlink_to("wheel.txt")
    before = [(tmp_path / name).read_bytes() for name in names]
    for name in [*names, "link.txt"]:
        with pytest.raises(wrcontact.InvalidArgument, match=f"path is .*{name}, which is read as .*; must be another file"):
            wrcontact.report("wheel.txt", "rail.txt", tmp_path / name, limits="limits.csv", nominal_wheel="wheel0.txt")
    with pytest.raises(wrcontact.InvalidArgument, match="must be another file"):
        wrcontact.Profile("wheel.txt").write(tmp_path / "link.txt")
    assert [(tmp_path / name).read_bytes() for name in names] == before


def test_a_page_that_cannot_be_written_leaves_the_old_one(tmp_path):
    page = tmp_path / "r.html"
    page.write_text("old", encoding="utf-8")
    page.chmod(0o600)
    _write_whole(str(page), "new")
    assert page.read_text(encoding="utf-8") == "new" and page.stat().st_mode & 0o777 == 0o600
    with pytest.raises(UnicodeEncodeError):
        _write_whole(str(page), "half \udc80")
    assert page.read_text(encoding="utf-8") == "new" and list(tmp_path.iterdir()) == [page]


def test_the_checksum_is_that_of_the_file_that_was_read(tmp_path):
    path = tmp_path / "wheel.txt"
    wrcontact.Profile("S1002").write(path)
    profiles = wrcontact.Profile(path), wrcontact.Profile.from_file(path, kind="wheel")
    digest = hashlib.sha256(path.read_bytes()).hexdigest()
    path.unlink()
    assert all(_origin(profile).endswith(f"SHA-256 {digest}") for profile in profiles)


def test_limits_are_checked():
    assert verdict(1.0, 0.0, None, 1.0) == "pass" and verdict(1.1, 0.0, None, 1.0) == "fail"
    assert verdict(1.0, 0.1, None, 1.05) == "pass, within its spread of the limit" and verdict(0.9, 0.0, 1.0, None) == "fail"
    assert verdict(float("nan"), 0.0, 1.0, None) == "not known"
    assert verdict(1.0, float("nan"), None, 1.5) == "pass, spread unknown" and verdict(2.0, float("nan"), None, 1.5) == "fail"
    with pytest.raises(wrcontact.InvalidArgument, match="'pmx' is no quantity of a report; must be one of qr, pmax"):
        limits_of({"pmx": (None, 1.0)}, ["qr", "pmax"])


HEAD = "quantity,least,greatest,source\n"


@pytest.mark.parametrize("text, trouble", [
    ("quantity,most\nqr,5\n", "must have the columns quantity, least, greatest, source"), (HEAD, "has no limits"),
    ("quantity,least,least,greatest,source\nqr,1,2,3,x\n", "a column is given twice"), (HEAD + "qr,1\n", "another number of entries"),
    (HEAD + "qr,nan,,x\n", "'nan'"), (HEAD + "qr,20,5,x\n", "limits of qr"), (HEAD + "qr,,,\n", "None, None"), (HEAD + "qr,,inf,x\n", "inf")])
def test_a_file_with_bad_limits_is_refused(tmp_path, text, trouble):
    (tmp_path / "limits.csv").write_text(text, encoding="utf-8")
    with pytest.raises(wrcontact.InvalidArgument, match=f"limits.csv: .*{trouble}"):
        limits_of(tmp_path / "limits.csv", ["qr"])


@pytest.mark.parametrize("pair", [7, ("7", None, 8), ("x", None), (None, None), (float("nan"), 1), (2, 1)])
def test_bad_limits_of_a_dict_are_refused_before_solving(monkeypatch, pair):
    monkeypatch.setattr(wrcontact.Profile, "conicity", lambda *_, **__: pytest.fail("solves before it refuses"))
    with pytest.raises(wrcontact.InvalidArgument, match="the limits of qr are .*; must be two finite numbers"):
        wrcontact.report("S1002", "60E1", "/nowhere/r.html", limits={"qr": pair})


def test_limits_as_excel_writes_them_are_read(tmp_path):
    (tmp_path / "limits.csv").write_bytes(b"\xef\xbb\xbf" + HEAD.replace("\n", "\r\n").encode() + b"qr,,5,x\r\n")
    assert limits_of(tmp_path / "limits.csv", ["qr"]) == [("qr", None, 5.0, "x")]


@pytest.mark.parametrize("key, name", [
    ("lateral", "pose.lateral"), ("side", "solve.side"), ("until", "solve.until"), ("units", "convention.units"),
    ("frame", "convention.frame"), ("track_left_rail", "track.left.rail"), ("wheelset_right_wheel", "wheelset.right.wheel"),
    ("track.rail.smoothing", "track.rail.smoothing"), ("track.left.rail.shift", "track.left.rail.shift")])
def test_what_report_and_conicity_set_themselves_is_refused(key, name):
    with pytest.raises(wrcontact.InvalidArgument, match=f"{key}: the report sets {name} itself"):
        wrcontact.report("S1002", "60E1", "/nowhere/r.html", **{key: 3})
    with pytest.raises(wrcontact.InvalidArgument, match=f"{key}: the conicity sets {name} itself"):
        wrcontact.Profile("S1002").conicity("60E1", **{key: 3})


def test_a_default_can_be_given_by_any_word_of_its_key(monkeypatch):
    wheel = wrcontact.Profile("S1002")
    assert wheel.conicity("60E1", [3.0], pose_roll="solve").value != wheel.conicity("60E1", [3.0]).value

    def show(*_, **keys):
        raise ZeroDivisionError(str(keys))

    monkeypatch.setattr(wrcontact.Profile, "conicity", show)
    with pytest.raises(ZeroDivisionError, match="^{'solve_accuracy': 0.1}$"):
        wrcontact.report(wheel, "60E1", "/nowhere/r.html", solve_accuracy=0.1)
