"""Bodies of shells with known modes, for the tests of figures."""

import numpy as np

COLUMNS, ROWS = 4, 2
MODES = 11


def plate_nodes():
    """A grid over 4 m x 2 m in the plane z = 1 m."""
    return np.array([[i, j, 1.0] for j in range(ROWS + 1) for i in range(COLUMNS + 1)])


def surfaces():
    """Quadrilaterals, of which the last is cut into two triangles."""
    corners = [[j * (COLUMNS + 1) + i + k for k in (0, 1, COLUMNS + 2, COLUMNS + 1)]
               for j in range(ROWS) for i in range(COLUMNS)]
    a, b, c, d = corners.pop()
    return np.array([*corners, [a, b, c, -1], [a, c, d, -1]])


def pipe_nodes():
    """The same grid on half a cylinder of radius 1 m about the y axis."""
    angle, y = np.pi / COLUMNS * plate_nodes()[:, 0], plate_nodes()[:, 1]
    return np.column_stack([np.cos(angle), y, np.sin(angle)])


def plate_shapes():
    """Mode 1: across by 2 x, downwards; mode 2: x along x; others: across by 1."""
    shapes = np.zeros((len(plate_nodes()), 6, MODES))
    shapes[:, 2, :] = 1
    shapes[:, 2, 0] = -2 * plate_nodes()[:, 0]
    shapes[:, 2, 1] = 0
    shapes[:, 0, 1] = plate_nodes()[:, 0]
    return shapes


def pipe_shapes():
    """Outwards, by y."""
    shapes = np.zeros((len(pipe_nodes()), 6, 1))
    shapes[:, [0, 2], 0] = pipe_nodes()[:, [0, 2]] * pipe_nodes()[:, [1]]
    return shapes


def write_shells(writer):
    """A modal analysis and the bodies plate, tilted (the plate, turned) and pipe."""
    writer.analysis("shapes", "modal", [])
    turn = np.array([[2, -1, 2], [2, 2, -1], [-1, 2, 2]]).T / 3
    for name, nodes, shapes in [("plate", plate_nodes(), plate_shapes()),
                                ("tilted", plate_nodes() @ turn, np.zeros((15, 6, 2))),
                                ("pipe", pipe_nodes(), pipe_shapes())]:
        if name == "tilted":
            shapes[:, :3, :] = np.einsum("nam,ab->nbm", plate_shapes()[:, :3, :2], turn)
        group = writer.file.create_group(f"body/{name}")
        group.attrs["type"] = "shell"
        for key, values in [("nodes", nodes), ("surfaces", surfaces()), ("shapes", shapes),
                            ("frequency", 1.5 * np.arange(1.0, shapes.shape[2] + 1))]:
            group.create_dataset(key, data=values).attrs["unit"] = "1"
    writer.file["body/plate"].create_dataset("lines", data=[[0, 1], [1, 2]]).attrs["unit"] = "1"
