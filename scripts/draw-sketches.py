#!/usr/bin/env python3
"""Draws the sketches of the gallery's systems: draw-sketches.py [--check] [FOLDER]

One SVG for each system, into docs/gallery/sketches unless a folder is given. Symbols are those of the pages, which
are those of the papers. Blue is what moves or excites, red what touches. --check writes nothing; it lists the files
that are not as they would be drawn, and ends with 1 if there are any.
"""

import argparse
import math
import sys
from pathlib import Path

sys.dont_write_bytecode = True
import sketches_of_beams  # noqa: E402
import sketches_that_turn  # noqa: E402
import sketches_with_friction  # noqa: E402
from sketch_shapes import CONTACT, INK, MOTION, PALE, Sketch  # noqa: E402

GALLERY = Path(__file__).resolve().parent.parent / "docs" / "gallery" / "sketches"


def cantilever(sketch, foot, height, symbol, lean):
    """An upright beam on the ground with a round head, and its shape when the head is pulled aside."""
    x, y = foot
    def bent(s):  # of a force at the end
        return (x + lean * s * s * (3 - s) / 2, y - height * s)
    sketch.curve(bent, 0, 1, colour=PALE, width=3, dashes="5 4")
    sketch.circle(bent(1), 22, colour=PALE, fill="none", dashes="5 4")
    sketch.line(foot, (x, y - height), width=4)
    sketch.circle((x, y - height), 22)
    sketch.symbol((x, y - height), symbol)


def impacting_beams():
    sketch = Sketch("Two upright cantilevers with round heads, a clearance between the heads; the ground under the "
                    "left one shakes")
    left, right, base = 100, 170, 250
    for x, lean in ((left, -62), (right, 62)):
        cantilever(sketch, (x, base), 190, "m", lean)
        sketch.ground((x - 30, base), (x + 30, base))
    sketch.clearance((left + 22, 60), (right - 22, 60), "Δ", offset=-52, side=-1)
    sketch.symbol((left - 26, 172), "EI, ρA", anchor="end")
    sketch.clearance((right + 78, base), (right + 78, 60), "L", side=1)
    sketch.arrow((left - 25, base + 26), (left + 25, base + 26), both=True)
    sketch.symbol((left, base + 44), "x_0(t)", colour=MOTION)
    sketch.line((left + 22, 60), (left + 22, 52), width=0.7)
    sketch.symbol(((left + right) / 2, 88), "k, μ", colour=CONTACT)
    return sketch


def identification():
    sketch = Sketch("Two upright cantilevers with round heads, drawn apart to a distance S and released; a force transducer on the right head")
    for x, lean, place in ((100, -62, "P_1"), (190, 62, "P_2")):
        cantilever(sketch, (x, 250), 190, "", lean)
        sketch.ground((x - 30, 250), (x + 30, 250))
        sketch.symbol((x + 1.25 * lean, 60), place, colour=MOTION)
    sketch.mass((162, 60), 12, 18, fill=CONTACT)
    for left, right, offset, name in ((122, 156, -38, "Δ"), (60, 230, -66, "S")):
        sketch.clearance((left, 60), (right, 60), name, offset=offset, side=-1)
    sketch.clearance((100, 250), (190, 250), "H", offset=26)
    sketch.symbol((145, 92), "F", colour=CONTACT)
    return sketch


def isolator(symbols):
    """A mass between two stops; symbols of spring, dashpot, stop's spring and dashpot, clearance, force, motion."""
    spring, dashpot, stop_spring, stop_dashpot, clearance, force, motion = symbols
    sketch = Sketch("A mass on a spring and a dashpot, driven by a harmonic force, between an upper and a lower stop, "
                    "each a spring and a dashpot behind a clearance")
    sketch.mass((170, 190), 220, 50, "m" if clearance != "1" else "1")
    sketch.ground((50, 360), (270, 360))
    sketch.spring((75, 360), (75, 215), spring, side=-1)
    sketch.dashpot((115, 360), (115, 215), dashpot)
    sketch.stop((225, 360), (225, 245), 30, (stop_spring, stop_dashpot))
    sketch.ground((280, 20), (170, 20))
    sketch.stop((225, 20), (225, 135), 30, (stop_spring, stop_dashpot))
    for face, side in ((245, 215), (135, 165)):
        sketch.clearance((262, side), (262, face), clearance, offset=40 if face < side else -40,
                         side=1 if face < side else -1)
    sketch.arrow((120, 165), (120, 105))
    sketch.symbol((120, 92), force, colour=MOTION)
    sketch.arrow((40, 200), (40, 150))
    sketch.symbol((40, 138), motion, colour=MOTION)
    sketch.line((40, 200), (58, 200), colour=MOTION, width=0.8)
    return sketch


def isolator_stop():
    return isolator(("1", "2ζ_0", "μ", "2ζ_1", "1", "f sin λτ", "y"))


def isolator_design():
    return isolator(("k", "c", "μk", "c_1", "δ", "F sin ωt", "x"))


def bumpers():
    sketch = Sketch("A mass on a spring and a dashpot on a shaking base, between two bumpers that are a spring and a "
                    "dashpot each, a gap away")
    sketch.line((60, 210), (460, 210), width=2.4)
    for wall, face, edge, side in ((60, 170, 220, -1), (460, 350, 300, 1)):
        sketch.line((wall, 50), (wall, 210), width=2.4)
        sketch.line((face, 58), (face, 124), colour=CONTACT, width=3)
        sketch.spring((wall, 74), (face, 74), "λ", side=side, colour=CONTACT, half_width=6)
        sketch.dashpot((wall, 108), (face, 108), "2ξγ", side=-side, colour=CONTACT, half_width=6)
        sketch.clearance((min(face, edge), 58), (max(face, edge), 58), "δ_0", offset=-22, side=-1)
    sketch.mass((260, 128), 80, 140, "1")
    for wheel in (238, 282):
        sketch.circle((wheel, 203), 6)
    sketch.spring((60, 172), (220, 172), "1", half_width=6)
    sketch.dashpot((460, 172), (300, 172), "2ξ", side=-1, half_width=6)
    sketch.arrow((260, 40), (292, 40))
    sketch.line((260, 58), (260, 32), colour=MOTION, width=0.8)
    sketch.symbol((276, 24), "q", colour=MOTION)
    sketch.arrow((225, 230), (295, 230), both=True)
    sketch.symbol((260, 248), "a_G sin βτ", colour=MOTION)
    return sketch


def absorber():
    sketch = Sketch("A floor on a spring and a dashpot, driven by a harmonic force; on it a damper on a spring and a "
                    "dashpot in a chamber that ends at the floor on the left and at a barrier on the right")
    sketch.ground((30, 40), (30, 230))
    sketch.spring((30, 80), (110, 80), "k_1", side=-1)
    sketch.dashpot((30, 150), (110, 150), "c_1")
    body = [(110, 50), (180, 50), (180, 185), (470, 185), (470, 50), (500, 50), (500, 215), (110, 215)]
    sketch.path(body, closed=True, fill="#dbe4ee")
    sketch.symbol((145, 125), "m_1")
    sketch.circle((130, 224), 9)
    sketch.circle((480, 224), 9)
    sketch.ground((100, 234), (510, 234))
    sketch.mass((330, 120), 66, 66, "m_2")
    for side, foot, sign in ((297, 180, 1), (363, 470, -1)):
        sketch.curve(lambda s, side=side, sign=sign: (side - sign * 13 * math.cos(s), 120 + 24 * math.sin(s)),
                     -math.pi / 2, math.pi / 2, colour=CONTACT, width=2.4)
        sketch.curve(lambda s, foot=foot, sign=sign: (foot + sign * 13 * math.cos(s), 120 + 24 * math.sin(s)),
                     -math.pi / 2, math.pi / 2, colour=CONTACT, width=2.4)
    sketch.spring((180, 68), (312, 68), "k_2", coils=6)
    sketch.line((312, 68), (312, 87))
    sketch.dashpot((180, 170), (312, 170), "c_2", side=-1)
    sketch.line((312, 170), (312, 153))
    sketch.clearance((193, 120), (284, 120), "D")
    sketch.words((420, 172), "barrier", anchor="middle", size=13)
    sketch.clearance((376, 120), (457, 120), "C − D", side=-1)
    sketch.coordinate((145, 40), (205, 40), ((145, 48), (145, 30)), (214, 38), "x_1,  P cos ωt")
    sketch.coordinate((345, 78), (400, 78), ((345, 86), (345, 68)), (408, 76), "x_2")
    return sketch


def rigid_stop():
    sketch = Sketch("A mass on a spring and a dashpot, driven by a harmonic force, in front of a rigid stop")
    sketch.ground((30, 30), (30, 170))
    sketch.spring((30, 65), (150, 65), "1", side=-1)
    sketch.dashpot((30, 120), (150, 120), "0.1")
    sketch.mass((190, 92), 80, 90, "1")
    sketch.circle((168, 146), 9)
    sketch.circle((212, 146), 9)
    sketch.ground((120, 156), (255, 156))
    sketch.ground((320, 150), (320, 40))
    sketch.line((320, 60), (320, 126), colour=CONTACT, width=4)
    sketch.clearance((230, 92), (320, 92), "1", side=-1)
    sketch.symbol((346, 92), "e = 0.8", colour=CONTACT, anchor="start")
    sketch.coordinate((190, 34), (250, 34), ((190, 46), (190, 26)), (258, 32), "x,  A cos ωt")
    return sketch


def bilinear_oscillator():
    sketch = Sketch("Two masses side by side, each on a spring and a dashpot on a base that moves; a gap with a stiff "
                    "contact spring between them")
    sketch.path([(30, 40), (46, 40), (46, 170), (474, 170), (474, 40), (490, 40), (490, 186), (30, 186)],
                closed=True, fill="#eceef1")
    for x, side, symbols in ((190, 46, ("k_1", "c_1", "m_1")), (330, 474, ("k_2", "c_2", "m_2"))):
        sketch.mass((x, 105), 70, 84, symbols[2])
        near = x - 35 if side < x else x + 35
        upper = -1 if side < x else 1
        sketch.spring((side, 80), (near, 80), symbols[0], side=upper)
        sketch.dashpot((side, 130), (near, 130), symbols[1], side=-upper if side < x else 1 * -upper)
        for wheel in (x - 20, x + 20):
            sketch.circle((wheel, 158), 9)
    sketch.spring((225, 105), (268, 105), colour=CONTACT, coils=3, half_width=7)
    sketch.symbol((247, 86), "k*", colour=CONTACT)
    sketch.line((268, 88), (268, 122), colour=CONTACT, width=3)
    sketch.clearance((268, 122), (295, 122), "g_0", offset=6)
    for x, symbol in ((190, "x_1"), (330, "x_2")):
        sketch.coordinate((x, 42), (x + 50, 42), ((x, 58), (x, 34)), (x + 58, 40), symbol)
    sketch.arrow((225, 206), (295, 206), both=True)
    sketch.symbol((260, 224), "x_0 = X_0 sin ωt", colour=MOTION)
    return sketch


def electromechanical():
    sketch = Sketch("A casing on a spring, a cubic spring and a dashpot on a moving baseplate; in it an unbalanced "
                    "rotor and, on a spring between an upper and a lower stop, the impact element")
    sketch.path([(60, 30), (380, 30), (380, 300), (60, 300)], closed=True)
    sketch.path([(74, 44), (366, 44), (366, 286), (74, 286)], closed=True, fill="white")
    sketch.circle((145, 165), 52)
    sketch.line((145, 165), (175, 140), width=1)
    sketch.circle((175, 140), 6, fill=INK)
    sketch.circle((145, 165), 2.5, fill=INK)
    sketch.symbol((152, 143), "e", anchor="end")
    sketch.symbol((145, 190), "m_R, J")
    sketch.curve(lambda s: (145 + 64 * math.cos(s), 165 - 64 * math.sin(s)), -0.5, 0.75, colour=MOTION)
    sketch.arrow_head((145 + 64 * math.cos(0.62), 165 - 64 * math.sin(0.62)),
                      (145 + 64 * math.cos(0.75), 165 - 64 * math.sin(0.75)), MOTION)
    sketch.symbol((214, 150), "φ", colour=MOTION, anchor="start")
    sketch.symbol((145, 244), "M(φ′)", colour=MOTION)
    sketch.symbol((88, 62), "m", anchor="start")
    sketch.mass((305, 165), 74, 56, "m_t")
    sketch.spring((255, 44), (255, 165), "k_t", side=1)
    sketch.line((255, 165), (268, 165))
    sketch.stop((312, 44), (312, 105), 20, ("k_c", "b_c"))
    sketch.stop((312, 286), (312, 225), 20, ("k_c", "b_c"))
    sketch.clearance((347, 137), (347, 105), "", offset=10)
    sketch.clearance((347, 193), (347, 225), "", offset=-10)
    for y in (121, 209):
        sketch.symbol((349, y), "c", anchor="end")
    sketch.spring((100, 380), (100, 300), "k_1", side=-1, coils=4)
    sketch.spring((220, 380), (220, 300), "k_3", side=1, coils=4)
    sketch.line((205, 358), (237, 322), width=1)
    sketch.arrow_head((205, 358), (237, 322), INK)
    sketch.dashpot((340, 380), (340, 300), "b")
    sketch.line((60, 380), (380, 380), width=3)
    for x, y, symbol in ((35, 230, "y"), (35, 380, "y_z")):
        sketch.coordinate((x, y), (x, y - 46), ((x - 8, y), (x + 22, y)), (x - 6, y - 30), symbol, anchor="end")
    sketch.coordinate((400, 165), (400, 119), ((342, 165), (408, 165)), (408, 136), "y_t")
    return sketch


def cantilever_stop():
    sketch = Sketch("A clamped round beam that a force pushes at its tip towards an elastic stop below")
    sketch.ground((40, 50), (40, 130))
    sketch.path([(40, 82), (400, 82), (400, 98), (40, 98)], closed=True, fill="#dbe4ee")
    sketch.arrow((392, 24), (392, 78), width=2.2)
    sketch.symbol((402, 36), "F", colour=MOTION, anchor="start")
    sketch.stop((392, 210), (392, 124), 16, ("k",))
    sketch.ground((360, 210), (425, 210))
    sketch.clearance((376, 98), (376, 124), "δ", offset=14, side=1)
    sketch.symbol((200, 64), "E, ρ, L, d")
    return sketch


def measured_modes():
    sketch = Sketch("A clamped rod, known at five points that a modal test has measured, above an elastic stop")
    sketch.ground((40, 50), (40, 130))
    sketch.path([(40, 84), (400, 84), (400, 96), (40, 96)], closed=True, fill="#dbe4ee")
    for number, name in enumerate(("root", "p25", "p50", "p75", "tip")):
        centre = (40 + 88 * number, 90)
        sketch.circle(centre, 4, fill=MOTION)
        sketch.words((centre[0] + (22 if name == "root" else 0), 70) if name != "tip" else (418, 95), name,
                     colour=MOTION)
    sketch.arrow((392, 24), (392, 78), width=2.2)
    sketch.symbol((402, 36), "F", colour=MOTION, anchor="start")
    sketch.stop((392, 210), (392, 124), 22, ("k", "c"))
    sketch.ground((360, 210), (425, 210))
    sketch.clearance((372, 96), (372, 124), "δ", offset=14, side=1)
    return sketch


def plate_on_stops(sketch, x, y):
    sketch.line((x, y), (x + 240, y), width=5)
    for end in (x, x + 240):
        sketch.path([(end, y + 3), (end - 9, y + 19), (end + 9, y + 19)], closed=True, fill="white")
    for i in range(5):
        foot = x + 40 + 40 * i
        sketch.spring((foot, y + 60), (foot, y + 22), coils=3, half_width=6, colour=CONTACT)
        sketch.line((foot - 8, y + 22), (foot + 8, y + 22), colour=CONTACT, width=3)
    for end in (x, x + 240):
        sketch.line((end, y + 19), (end, y + 60))
    sketch.line((x - 15, y + 60), (x + 255, y + 60), width=3)
    sketch.arrow((x + 120, y + 72), (x + 120, y + 102), both=True)
    sketch.words((x + 132, y + 90), "shaken table", anchor="start", colour=MOTION)


def tubes(sketch, x, y):
    sketch.circle((x, y), 54, width=4, fill="white")
    sketch.circle((x, y), 38, width=4, fill="white")
    for k in range(10):
        angle = math.pi * (0.2 * k + 0.1)
        sketch.line((x + 41 * math.cos(angle), y + 41 * math.sin(angle)),
                    (x + 51 * math.cos(angle), y + 51 * math.sin(angle)), colour=CONTACT, width=2.4)
    sketch.words((x, y + 78), "tube in a tube")


def frames(sketch, x, y):
    for left, storeys in ((x, 4), (x + 92, 3)):
        for column in (left, left + 70):
            sketch.line((column, y), (column, y - 42 * storeys), width=3)
        for floor in range(1, storeys + 1):
            sketch.line((left, y - 42 * floor), (left + 70, y - 42 * floor), width=5)
        sketch.ground((left - 10, y), (left + 80, y))
    for floor in (1, 2, 3):
        sketch.line((x + 74, y - 42 * floor), (x + 88, y - 42 * floor), colour=CONTACT, width=3)
    sketch.arrow((x + 56, y + 24), (x + 106, y + 24), both=True)
    sketch.words((x + 81, y + 40), "earthquake", colour=MOTION)


def many_contacts():
    sketch = Sketch("Left: a plate, supported at its edges, above a row of stops on a shaken table. Middle: a tube in a "
                    "tube. Right: two frames side by side that meet at their floors")
    plate_on_stops(sketch, 30, 90)
    tubes(sketch, 370, 110)
    frames(sketch, 480, 190)
    return sketch


def panel_words(sketch, x, text):
    sketch.words((x, 186), text)


def square_plate(sketch, x):
    corners = [(x, 140), (x + 110, 140), (x + 150, 70), (x + 40, 70)]
    sketch.path(corners, closed=True, fill="#dbe4ee")
    for s in (0.25, 0.5, 0.75):
        sketch.line((x + 40 * s, 140 - 70 * s), (x + 110 + 40 * s, 140 - 70 * s), width=0.7)
        sketch.line((x + 110 * s, 140), (x + 40 + 110 * s, 70), width=0.7)
    for foot in corners[:2]:
        sketch.path([foot, (foot[0] - 6, foot[1] + 12), (foot[0] + 6, foot[1] + 12)], closed=True, fill="white")
    panel_words(sketch, x + 72, "plates (FV12, 13H, FV22)")


def roof(sketch, x):
    def arc(shift):
        return lambda s: (x + 55 + 62 * math.sin(s) + shift[0], 128 - 62 * math.cos(s) + shift[1])
    half = 2 * math.pi / 9
    near, far = arc((0, 15)), arc((60, -15))
    outline = [near(-half + half * i / 10) for i in range(21)]
    outline += [far(half - half * i / 10) for i in range(21)]
    sketch.path(outline, closed=True, fill="#dbe4ee")
    for s in (-0.5, 0, 0.5):
        sketch.line(near(s * half), far(s * half), width=0.7)
    for s in (0.25, 0.5, 0.75):
        sketch.curve(arc((60 * s, 15 - 30 * s)), -half, half, width=0.7)
    sketch.arrow((x + 85, 30), (x + 85, 62))
    panel_words(sketch, x + 85, "roof")


def cylinder(sketch, x):
    y, width, height = 105, 120, 46
    def ellipse(shift):
        return lambda s: (x + shift + 18 * math.cos(s), y + height * math.sin(s))
    outline = [ellipse(0)(math.pi / 2 + math.pi * i / 20) for i in range(21)]
    outline += [ellipse(width)(-math.pi / 2 + math.pi * i / 20) for i in range(21)]
    sketch.path(outline, closed=True, fill="#dbe4ee")
    sketch.curve(ellipse(width), 0, 2 * math.pi, width=1)
    for s in (0.25, 0.5, 0.75):
        sketch.curve(ellipse(width * s), math.pi / 2, 3 * math.pi / 2, width=0.7)
    sketch.arrow((x + width / 2, 24), (x + width / 2, y - height))
    sketch.arrow((x + width / 2, 176), (x + width / 2, y + height))
    panel_words(sketch, x + width / 2, "pinched cylinder")


def twisted_beam(sketch, x):
    def edge(side):
        return lambda s: (x + 130 * s + side * 8 * math.sin(math.pi * s / 2),
                          105 + side * 34 * math.cos(math.pi * s / 2) - 20 * s)
    outline = [edge(1)(i / 20) for i in range(21)] + [edge(-1)(1 - i / 20) for i in range(21)]
    sketch.path(outline, closed=True, fill="#dbe4ee")
    for i in range(1, 8):
        sketch.line(edge(1)(i / 8), edge(-1)(i / 8), width=0.7)
    sketch.ground((x, 60), (x, 150))
    sketch.arrow((x + 133, 38), (x + 133, 80))
    panel_words(sketch, x + 65, "twisted beam")


def plates_and_shells():
    sketch = Sketch("Four of the benchmarks: a square plate, a roof under its weight, a pinched cylinder, a twisted "
                    "beam with a force at its end")
    square_plate(sketch, 20)
    roof(sketch, 205)
    cylinder(sketch, 405)
    twisted_beam(sketch, 590)
    return sketch


def given_matrices():
    sketch = Sketch("An upright bar with a right angle, given by the stiffness and mass of another program, above a stop; "
                    "the ground moves upwards and downwards")
    foot, knee, tip = (80, 250), (80, 70), (330, 70)
    sketch.ground((45, 250), (115, 250))
    sketch.line(foot, knee, width=4)
    sketch.line(knee, tip, width=4)
    sketch.symbol((205, 50), "K, M")
    sketch.ground((305, 130), (355, 130))
    sketch.clearance((380, 130), (380, 70), "Δ", side=1)
    sketch.symbol((290, 160), "k, c", colour=CONTACT)
    sketch.arrow((150, 285), (150, 235), both=True)
    sketch.symbol((165, 262), "z_0(t)", colour=MOTION, anchor="start")
    return sketch


def block(sketch, corner, length, height, depth=14):
    """A box seen from the front, above and the right."""
    (x, y), d = corner, depth
    sketch.path([(x, y), (x + d, y - d), (x + length + d, y - d), (x + length, y)], closed=True, fill="#dbe4ee")
    sketch.path([(x + length, y), (x + length + d, y - d), (x + length + d, y + height - d), (x + length, y + height)],
                closed=True, fill="#b9c8d8")
    sketch.path([(x, y), (x + length, y), (x + length, y + height), (x, y + height)], closed=True, fill="#dbe4ee")


def solids():
    sketch = Sketch("Left: a bar meets an equal one end to end, across a stiff spring. Right: a clamped block on a shaken "
                    "table above stops at one side of its free end")
    for x, symbol in ((20, "E, ρ, S"), (212, "L")):
        block(sketch, (x, 70), 140, 30)
        sketch.symbol((x + 70, 85), symbol)
    sketch.spring((174, 77), (212, 77), "k", side=-1, coils=3, colour=CONTACT, half_width=5)
    sketch.arrow((60, 128), (120, 128))
    sketch.symbol((134, 128), "v", colour=MOTION)
    block(sketch, (440, 70), 190, 28, 34)
    sketch.ground((440, 36), (440, 112))
    for x in (590, 625):
        sketch.stop((x, 148), (x, 110), 8, ("",))
        sketch.ground((x - 12, 148), (x + 12, 148))
    sketch.arrow((480, 160), (480, 115), both=True)
    sketch.symbol((492, 150), "z_0(t)", colour=MOTION, anchor="start")
    return sketch


SKETCHES = {
    "impacting-beams": impacting_beams, "identification": identification, "isolator-stop": isolator_stop, "isolator-design": isolator_design,
    "bumpers": bumpers, "vibro-impact-absorber": absorber, "rigid-stop": rigid_stop, "bilinear-oscillator": bilinear_oscillator,
    "electromechanical": electromechanical, "cantilever-stop": cantilever_stop, "measured-modes": measured_modes, "many-contacts": many_contacts,
    "plates-and-shells": plates_and_shells, "given-matrices": given_matrices, "solids": solids, **sketches_with_friction.SKETCHES, **sketches_that_turn.SKETCHES, **sketches_of_beams.SKETCHES}


def outdated(folder: Path) -> list[Path]:
    files = {folder / f"{name}.svg": draw() for name, draw in SKETCHES.items()}
    wrong = [file for file, sketch in files.items()
             if not file.exists() or file.read_text(encoding="utf-8") != sketch.as_svg()]
    return wrong + [file for file in folder.glob("*.svg") if file not in files]


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path, nargs="?", default=GALLERY)
    parser.add_argument("--check", action="store_true")
    options = parser.parse_args()
    if options.check:
        wrong = outdated(options.folder)
        for file in wrong:
            print(f"{file} is not what draw-sketches.py draws", file=sys.stderr)
        return 1 if wrong else 0
    options.folder.mkdir(parents=True, exist_ok=True)
    for name, draw in SKETCHES.items():
        (options.folder / f"{name}.svg").write_text(draw().as_svg(), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
