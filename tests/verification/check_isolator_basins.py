#!/usr/bin/python3
"""Isolator with a damped elastic stop: how many starts lead to its small and to its large motion at
lambda = 1.3, against an independent count of cells by event-located integration.
"""
import numpy

from systems import Table

SMALL_OF_640000 = 56223  # centres of 800 x 800 cells on [-3, 3] x [-3, 3]
SMALL_SHARE = 0.064756   # centres of 400 x 400 cells on [-6, 6] x [-8, 8]
AXIS = "Analysis/plane/Basins/{} axis/{}={}"


def plane(table, name, cells, first, second):
    ends = [AXIS.format("First", "First", -first), AXIS.format("First", "Last", first),
            AXIS.format("Second", "First", -second), AXIS.format("Second", "Last", second)]
    return table.run("isolator-basins.prm", name, "Analyses=plane",
                     AXIS.format("First", "Cells", cells), AXIS.format("Second", "Cells", cells),
                     *ends)["analysis/plane/cell/attractor"][:]


def check(table):
    cells = plane(table, "isolator-basins", 800, 3, 3)
    table.add("cells of 640 000 that lead to the small motion", SMALL_OF_640000,
              numpy.count_nonzero(cells == 0), 0, absolute=True)
    table.add("cells that lead to no motion or a third one", 0,
              numpy.count_nonzero((cells < 0) | (cells > 1)), 0, absolute=True)
    cells = plane(table, "isolator-basins-wide", 400, 6, 8)
    table.add("share of the small motion in the wide plane", SMALL_SHARE, (cells == 0).mean(),
              5e-7, absolute=True)
    nodes = table.run("isolator-basins.prm", "isolator-basins-nodes",
                      "Analyses=interpolated")["analysis/interpolated"]
    table.add("the same cells by an interpolated map, 400 nodes along each state", SMALL_OF_640000,
              numpy.count_nonzero(nodes["cell/attractor"][:] == 0), 10, absolute=True)


if __name__ == "__main__":
    main = Table(__file__)
    check(main)
    main.finish()
