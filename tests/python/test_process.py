"""Interpreters: silent imports, threads, forks, kills, reloads, archives."""
import multiprocessing
import os
import signal
import subprocess
import sys
import threading
import time

import pytest

import wrcontact


def pmax(lateral):
    return wrcontact.solve(lateral=lateral).left.pmax


def test_importing_prints_nothing_and_loads_nothing_large(python):
    done = python("import wrcontact, sys; print({'matplotlib', 'xarray'} & set(sys.modules))")
    assert (done.stdout, done.stderr, done.returncode) == ("set()\n", "", 0)


def test_a_library_that_is_missing_or_broken_is_an_import_error(python, tmp_path):
    folder = tmp_path / "wrcontact"
    folder.mkdir()
    for module in os.scandir(os.path.dirname(wrcontact.__file__)):
        if module.name.endswith(".py"):
            (folder / module.name).write_bytes(open(module.path, "rb").read())
    program = """
try:
    import wrcontact
except ImportError as error:
    print(error)
"""
    environment = {**os.environ, "PYTHONPATH": str(tmp_path)}
    assert "there is no libwrcontact.so.*" in python(program, env=environment).stdout
    (folder / "libwrcontact.so.0.4").write_text("not a library")
    assert "cannot be loaded" in python(program, env=environment).stdout


def test_eight_threads_give_the_same_bits():
    laterals = [-6 + 0.5 * step for step in range(24)]
    expected = [pmax(lateral) for lateral in laterals]
    found = {}

    def work(start):
        solver, scene = wrcontact.Solver(), wrcontact.Scene()
        for lateral in laterals[start:] + laterals[:start]:
            found[start, lateral] = solver.solve(scene.set(lateral=lateral)).left.pmax

    threads = [threading.Thread(target=work, args=(start,)) for start in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert [found[start, one] for start in range(8) for one in laterals] == expected * 8


def test_a_batch_gives_the_same_bits_on_any_number_of_threads():
    scenes = [wrcontact.Scene(lateral=lateral) for lateral in (-3, 0, 3, 5, 6.15)]
    expected = [scene.solve().left.pmax for scene in scenes]
    for threads in (1, 8):
        assert [one.left.pmax for one in wrcontact.solve_batch(scenes, threads=threads)] == expected
    scenes[1].set(lateral=100, roll="en15302")
    results = wrcontact.solve_batch(scenes, threads=2)
    assert isinstance(results[1], wrcontact.NoContact) and results[2].left.pmax == expected[2]
    with pytest.raises(wrcontact.InvalidArgument, match="between 1 and 1024"):
        wrcontact.solve_batch(scenes, threads=0)
    with pytest.raises(wrcontact.InvalidArgument, match="given twice"):
        wrcontact.solve_batch([scenes[0]] * 2)


def test_a_batch_lets_other_threads_of_python_run():
    scenes = [wrcontact.Scene(lateral=0.05 * step, accuracy=1e-4) for step in range(100)]
    thread = threading.Thread(target=wrcontact.solve_batch, args=(scenes,))
    times = [time.perf_counter()]
    thread.start()
    while thread.is_alive():
        times.append(time.perf_counter())
    # With the interpreter's lock held, one pause would be the batch itself.
    longest = max(after - before for before, after in zip(times, times[1:]))
    assert longest < 0.5 * (times[-1] - times[0])


@pytest.mark.parametrize("method", ["fork", "spawn"])
def test_processes_of_multiprocessing_solve(method):
    expected = [pmax(lateral) for lateral in (0, 3, 5)]  # the parent has used the library
    with multiprocessing.get_context(method).Pool(2) as pool:
        assert pool.map(pmax, (0, 3, 5)) == expected
        with pytest.raises(wrcontact.InvalidArgument, match="lateral = 20000"):
            pool.map(pmax, [20000])


def test_a_fork_beside_solving_threads_solves():
    stop = threading.Event()
    threads = [threading.Thread(target=lambda: [pmax(3) for _ in iter(stop.is_set, True)])
               for _ in range(2)]
    for thread in threads:
        thread.start()
    expected = pmax(5)
    for _ in range(5):
        child = os.fork()
        if child == 0:
            os._exit(0 if pmax(5) == expected else 1)
        assert os.waitpid(child, 0)[1] == 0
    stop.set()
    for thread in threads:
        thread.join()


def test_a_killed_interpreter_leaves_nothing_that_stops_the_next(python, tmp_path):
    program = "import wrcontact\nprint('ready', flush=True)\nwhile True: wrcontact.solve(lateral=5)"
    child = subprocess.Popen([sys.executable, "-B", "-c", program], stdout=subprocess.PIPE, cwd=tmp_path)
    assert child.stdout.readline() == b"ready\n"
    time.sleep(0.1)
    child.send_signal(signal.SIGKILL)
    assert child.wait() == -signal.SIGKILL and not os.listdir(tmp_path)
    child.stdout.close()
    done = python("import wrcontact; print(wrcontact.solve(lateral=5).left.pmax)", cwd=tmp_path)
    assert float(done.stdout) == pmax(5)


def test_a_package_that_is_loaded_again_solves(python):
    done = python("""
import importlib, sys, wrcontact
scene = wrcontact.Scene()
first = scene.solve().left.pmax
importlib.reload(wrcontact)
for name in [name for name in sys.modules if name.startswith("wrcontact")]:
    del sys.modules[name]
import wrcontact as again
print(again.Scene is not type(scene), again.solve().left.pmax == first == scene.solve().left.pmax)
""")
    assert done.stdout.split() == ["True", "True"] and not done.stderr
    # An interpreter that ends with live objects, and one that ends by an exception.
    done = python("import wrcontact; s = wrcontact.Scene(); r = s.solve(); s.me = s; raise SystemExit(3)")
    assert (done.returncode, done.stdout, done.stderr) == (3, "", "")


def test_handles_are_destroyed_with_their_objects(python):
    done = python("""
import resource, wrcontact
for count in range(150):
    wrcontact.solve(lateral=5)
    if count == 50:
        before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
print(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before)
""")
    kilobytes_of_pressures = 99 * 192 * 22 * 8 // 1024  # of the left wheels after the first
    assert int(done.stdout) < kilobytes_of_pressures // 2
