#!/usr/bin/env python3
"""Measures what Python adds to calls of the library, how threads scale, and a large study.

Usage: measure.py [calls | threads | study | all]

calls:   set, solve and read of a scene against the same calls of the C interface, made by a program
         in C that this one compiles (gcc).
threads: the same scenes on 1 and 2 threads of Python, and by one batch; real and processor time.
study:   10^5 scenes to a Dataset.
"""
import subprocess
import sys
import tempfile
import threading
import time
from pathlib import Path

import numpy as np

import wrcontact

PROGRAM = r"""
#include <stdio.h>
#include <time.h>
#include <wrcontact.h>
static double now(void) {
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return 1e6 * (double)t.tv_sec + 1e-3 * (double)t.tv_nsec;
}
int main(void) {
  enum { repeats = 7, calls = 20000 };
  wrc_scene* scene; wrc_solver* solver;
  double value, pose[2] = {0, 0}, read[2];
  int32_t keys[2], names[2];
  wrc_scene_create(&scene);
  wrc_solver_create(&solver);
  wrc_scene_set_text(scene, "solve.until", "geometry");
  wrc_solver_solve(solver, scene);
  wrc_scene_key_id(scene, "pose.lateral", keys); wrc_scene_key_id(scene, "pose.yaw", keys + 1);
  wrc_scene_number_id(scene, "roll", names); wrc_scene_number_id(scene, "left.vertical", names + 1);
#define TIME(call) { double best = 1e30; for (int r = 0; r < repeats; ++r) { double start = now(); \
    for (int i = 0; i < calls; ++i) { call; } \
    double took = (now() - start) / calls; if (took < best) best = took; } printf("%.4f\n", best); }
  TIME(wrc_scene_set_number(scene, "pose.lateral", 0.0))
  TIME(wrc_scene_number(scene, "left.rigid_contact.y", &value))
#undef TIME
#define TIME(call) { double best = 1e30; for (int r = 0; r < repeats; ++r) { double start = now(); \
    for (int i = 0; i < 300; ++i) { call; } \
    double took = (now() - start) / 300; if (took < best) best = took; } printf("%.4f\n", best); }
  TIME(wrc_solver_solve(solver, scene))
  return 0;
}
"""


def least(call, count, repeats=7):
    """The least time of one call over several runs, us."""
    times = []
    for _ in range(repeats):
        start = time.perf_counter()
        for _ in range(count):
            call()
        times.append((time.perf_counter() - start) / count * 1e6)
    return min(times)


def measure_calls():
    scene, solver = wrcontact.Scene(until="geometry"), wrcontact.Solver()
    solver.solve(scene)

    def set_key():
        scene["pose.lateral"] = 0.0

    mine = [least(set_key, 20000), least(lambda: scene.result["left.rigid_contact.y"], 20000),
            least(lambda: solver.solve(scene), 300)]
    project = Path(__file__).resolve().parents[2]
    library = next(Path(wrcontact.__file__).parent.glob("libwrcontact.so.*"))
    with tempfile.TemporaryDirectory() as folder:
        source = Path(folder, "calls.c")
        source.write_text(PROGRAM)
        subprocess.run(["gcc", "-O2", source, f"-I{project}/c_api/include", library.resolve(),
                        f"-Wl,-rpath,{library.parent}", "-o", f"{folder}/calls"], check=True)
        theirs = [float(line) for line in subprocess.run(
            [f"{folder}/calls"], check=True, capture_output=True, text=True).stdout.split()]
    print("call                          C, us  Python, us  beyond C, us")
    for name, c, python in zip(("scene[key] = number", "scene.result[name]", "solver.solve(scene)"), theirs, mine):
        print(f"{name:<26} {c:9.2f} {python:11.2f} {python - c:13.2f}")


def timed(work):
    """Real and processor time of a call, s."""
    real, processor = time.perf_counter(), time.process_time()
    work()
    return time.perf_counter() - real, time.process_time() - processor


def measure_threads(count=1200):
    laterals = np.linspace(-5, 5, count)

    def some(part):
        solver, scene = wrcontact.Solver(), wrcontact.Scene(accuracy=1e-3)
        for lateral in part:
            solver.solve(scene.set(lateral=lateral)).left.pmax

    def on(threads):
        workers = [threading.Thread(target=some, args=(laterals[start::threads],))
                   for start in range(threads)]
        for worker in workers:
            worker.start()
        for worker in workers:
            worker.join()

    scenes = [wrcontact.Scene(lateral=lateral, accuracy=1e-3) for lateral in laterals]
    for name, work in (("threads of Python", on),
                       ("solve_batch", lambda n: wrcontact.solve_batch(scenes, threads=n))):
        times = {n: min(timed(lambda n=n: work(n)) for _ in range(3)) for n in (1, 2, 8)}
        for n, (real, processor) in times.items():
            print(f"{name}, {n}: {real:.2f} s real, {processor:.2f} s of processors, "
                  f"{times[1][0] / real:.2f} times as fast as 1, {processor / real:.2f} cores in use")


def measure_study(count=100_000):
    random = np.random.default_rng(0)
    cases = {"lateral": ("case", random.uniform(-5, 5, count)),
             "yaw": ("case", random.uniform(-0.01, 0.01, count)),
             "load_both": ("case", random.uniform(2e4, 1e5, count))}
    names = ["left.depth", "left.total.force.y", "right.total.force.y", "left.pmax"]
    for told, values in (("geometry", {"until": "geometry"}),
                         ("Hertz", {"model": "hertz"}),
                         ("half-space, forces to 0.1", {"accuracy": 0.1, "accuracy_of": "forces"}),
                         ("half-space, forces to 1e-2", {"accuracy": 1e-2, "accuracy_of": "forces"})):
        start = time.perf_counter(), time.process_time()
        data = wrcontact.study(cases, names, threads=2, **values)
        real, processor = time.perf_counter() - start[0], time.process_time() - start[1]
        print(f"{count} scenes, {told}: {real:.1f} s real, {processor:.1f} s of processors, "
              f"{int((data['status'] != 0).sum())} failed", flush=True)


if __name__ == "__main__":
    parts = {"calls": measure_calls, "threads": measure_threads, "study": measure_study}
    asked = sys.argv[1] if len(sys.argv) == 2 else "all"
    if asked not in (*parts, "all"):
        sys.exit(__doc__)
    for part in parts if asked == "all" else [asked]:
        parts[part]()
