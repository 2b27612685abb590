"""Every status of the library has its exception, brought about by a real call where one can."""
import pickle
import threading

import numpy as np
import pytest

import wrcontact
from wrcontact import errors
from wrcontact._interface import ffi
from wrcontact._library import lib, string


def statuses():
    """All that the library has a name for, by their names."""
    unknown = string(lib.wrc_status_name(10**6))
    names = {string(lib.wrc_status_name(value)): value for value in range(1, 100)}
    return {name: value for name, value in names.items() if name != unknown}


def test_each_status_has_a_class_of_its_own():
    found = statuses()
    assert len(found) >= 11 and lib.WRC_BUSY in found.values()
    classes = {type(errors.error_of(status)) for status in found.values()}
    assert wrcontact.Error not in classes and len(classes) == len(found)
    for name, status in found.items():
        error = errors.error_of(status)
        assert error.status == status and str(error) == name
        again = pickle.loads(pickle.dumps(errors.error_of(status, "a text")))
        assert type(again) is type(error) and str(again) == "a text" and again.status == status


def test_a_status_of_a_later_library_is_an_error_too():
    error = errors.error_of(99)
    assert type(error) is wrcontact.Error and error.status == 99


@pytest.mark.parametrize("kind, call", {
    wrcontact.InvalidArgument: lambda folder: wrcontact.Scene(lateral=2e4),
    wrcontact.UnknownName: lambda folder: wrcontact.solve()["left.nothing"],
    wrcontact.FileUnreadable: lambda folder: wrcontact.Profile(folder / "none.prr"),
    wrcontact.FileMalformed: lambda folder: wrcontact.Profile(folder / "words.prr"),
    wrcontact.NoContact: lambda folder: wrcontact.solve(lateral=100, roll="en15302"),
    wrcontact.NotConverged: lambda folder: wrcontact.NormalContact(
        np.add.outer(np.arange(64.0) ** 2, np.arange(64.0) ** 2), 1, 1, approach=9,
        maximum_iterations=1).solve(),
    wrcontact.NoResult: lambda folder: wrcontact.NormalContact([[0.0]], 1, 1)["pmax"],
}.items())
def test_real_calls_raise(kind, call, tmp_path):
    (tmp_path / "words.prr").write_text("no profile at all\n")
    with pytest.raises(kind) as caught:
        call(tmp_path)
    assert caught.value.status == kind.status and len(str(caught.value)) > 10


def test_what_has_not_converged_can_be_read():
    with pytest.raises(wrcontact.NotConverged) as caught:
        wrcontact.solve(grid=[256, 128], tolerance=1e-13, method="paper")
    assert caught.value.result.left.pmax > 0.0


def test_an_array_that_is_too_small_is_refused():
    scene = wrcontact.Scene()
    scene.solve()
    count, values = ffi.new("int64_t *"), ffi.new("double[1]")
    with pytest.raises(wrcontact.TooSmall):
        scene._check(lib.wrc_scene_field(scene._handle, b"left.pressure", values, 1, count))


def test_a_scene_serves_one_thread_at_a_time():
    scene = wrcontact.Scene(lateral=5)
    refused = []  # by either thread: whoever comes second is refused

    def solve():
        while not refused:
            try:
                scene.solve()
            except wrcontact.Busy as error:
                refused.append(error)

    thread = threading.Thread(target=solve)
    thread.start()
    while not refused:  # ends only if this runs beside a solution, so the interpreter's lock is free
        try:
            scene["units"]
        except wrcontact.Busy as error:
            refused.append(error)
    thread.join()
    assert all(error.status == lib.WRC_BUSY for error in refused)


def test_memory_that_is_not_there(python):
    program = """
import resource, wrcontact
scene = wrcontact.Scene(grid=[2048, 2048])
wrcontact.solve()
pages = int(open("/proc/self/statm").read().split()[0])
limit = pages * resource.getpagesize() + 2**26  # two fields of the grid
resource.setrlimit(resource.RLIMIT_AS, (limit, limit))
try:
    scene.solve()
except wrcontact.OutOfMemory as error:
    print(error.status, isinstance(error, MemoryError))
print(wrcontact.solve().left.pmax > 0)
"""
    done = python(program)
    assert done.stdout.split() == ["6", "True", "True"], done.stderr
