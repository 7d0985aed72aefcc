"""Sketches of beams that vibrate freely, for draw-sketches.py."""
from sketch_shapes import CONTACT, MOTION, PALE, Sketch


def bending_beam(sketch, root, length, deflection):
    """A cantilever to the right of its wall, at rest and bent by a force at its tip; returns the tips."""
    x, y = root
    sketch.ground((x, y - 40), (x, y + 40))
    tips = []
    for way, style in ((deflection, {"colour": PALE, "width": 3, "dashes": "5 4"}), (0, {"width": 5})):
        def bent(s, way=way):
            return (x + length * s, y - way * s * s * (3 - s) / 2)
        sketch.curve(bent, 0, 1, **style)
        tips.append(bent(1))
    return tips


def nonlinear_modes():
    sketch = Sketch("Left: a cantilever with a spring of cubic force at its tip. Right: the same beam with a rigid stop a clearance away from its tip")
    bent, tip = bending_beam(sketch, (40, 110), 190, 34)
    sketch.spring(tip, (tip[0], tip[1] + 80), "k_3 u³", colour=CONTACT)
    sketch.ground((tip[0] + 30, tip[1] + 80), (tip[0] - 30, tip[1] + 80))
    sketch.arrow((tip[0] + 20, tip[1]), (tip[0] + 20, bent[1]))
    sketch.symbol((tip[0] + 30, (tip[1] + bent[1]) / 2), "u", colour=MOTION, anchor="start")
    bent, tip = bending_beam(sketch, (340, 110), 190, -30)
    sketch.line((tip[0] - 22, tip[1] - 30), (tip[0] + 22, tip[1] - 30), colour=CONTACT, width=4)
    sketch.ground((tip[0] + 22, tip[1] - 33), (tip[0] - 22, tip[1] - 33))
    sketch.clearance((tip[0] + 22, tip[1] - 30), (tip[0] + 22, tip[1]), "g_0", offset=18, side=1)
    sketch.symbol((410, 132), "EI, ρA")
    return sketch


SKETCHES = {"nonlinear-modes": nonlinear_modes}
