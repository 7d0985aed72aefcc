#!/usr/bin/python3
"""How the dynamic distribution of lines would keep many ranks busy, from the costs of a real run.

The cost of a line (one stepped sweep of a grid, or one grid point of another analysis) is counted
as BASE for each of its points and STEP for each integration step stored with them. Each rank takes
the next line when it has finished one, in the order of the grid, as the program does; the
efficiency is the sum of all costs over ranks times the time until the last is done.

usage: simulate_ranks.py RESULTS ANALYSIS [--base MICROSECONDS] [--step MICROSECONDS]
"""
import argparse
import heapq

import h5py
import numpy


def lines(file, analysis, base, step):
    """Cost of each line in seconds, in the order in which they are dealt out."""
    group = file["analysis"][analysis]
    steps = numpy.nan_to_num(group["steps"][()])
    keys = len(group.attrs["grid"])
    points = steps.reshape(int(numpy.prod(steps.shape[:keys])), -1)
    return 1e-6 * (base * points.shape[1] + step * points.sum(axis=1))


def finish(costs, ranks, message):
    """Time until the last rank is done; taking a line takes `message` seconds."""
    free = [0.0] * min(ranks, len(costs))
    for cost in costs:
        heapq.heappush(free, heapq.heappop(free) + message + cost)
    return max(free)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("results")
    parser.add_argument("analysis")
    parser.add_argument("--base", type=float, default=240, help="of a point [us]")
    parser.add_argument("--step", type=float, default=0.7, help="of a step [us]")
    parser.add_argument("--message", type=float, default=20, help="taking a line [us]")
    options = parser.parse_args()
    with h5py.File(options.results) as file:
        costs = lines(file, options.analysis, options.base, options.step)
    spread = numpy.percentile(costs, [1, 50, 99])
    print(f"{len(costs)} lines, {costs.sum():.0f} s; cheapest {costs.min():.3f} s, dearest "
          f"{costs.max():.3f} s; 1, 50, 99 %: {spread[0]:.3f}, {spread[1]:.3f}, {spread[2]:.3f} s")
    print("| ranks | time, s | efficiency | bound by the dearest line |\n| --- | --- | --- | --- |")
    for ranks in (1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024):
        time = finish(costs, ranks, 1e-6 * options.message)
        best = min(1.0, costs.sum() / ranks / costs.max())
        print(f"| {ranks} | {time:.2f} | {costs.sum() / ranks / time:.3f} | {best:.3f} |")


if __name__ == "__main__":
    main()
