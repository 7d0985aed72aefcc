"""Sketches of masses that turn, or that a random force drives, for draw-sketches.py."""
import math

from sketch_shapes import CONTACT, INK, MOTION, Sketch

STEPS = 10  # of an arc


def turning(sketch, centre, radius, start, end, symbol, colour=MOTION):
    """An arc with an arrow at its end, angles in degrees from x towards the top."""
    angles = [math.radians(start + (end - start) * i / STEPS) for i in range(STEPS + 1)]
    points = [(centre[0] + radius * math.cos(a), centre[1] - radius * math.sin(a)) for a in angles]
    sketch.path(points, colour=colour)
    sketch.arrow_head(points[-2], points[-1], colour)
    sketch.symbol((points[0][0] + (10 if points[0][0] > centre[0] else -10), points[0][1]), symbol, colour=colour,
                  anchor="start" if points[0][0] > centre[0] else "end")


def gear(sketch, centre, base, symbol):
    sketch.circle(centre, base + 9)
    sketch.circle(centre, base, dashes="4 3", fill="none")
    sketch.circle(centre, 5, fill="white")
    sketch.symbol((centre[0], centre[1] + 22), symbol)


def gear_rattle():
    sketch = Sketch("Left: pinion and wheel with their base circles and the line of action that is tangent to both. Right: on "
                    "this line a spring and a dashpot between the teeth, with backlash on both flanks")
    pinion, wheel = (110, 90), (110, 213)
    gear(sketch, pinion, 42, "J_1")
    gear(sketch, wheel, 63, "J_2")
    sketch.line((40, 140), (190, 140), colour=CONTACT, width=1.2, dashes="6 3")
    turning(sketch, pinion, 62, 10, 60, "M + M_a sin Ωt")
    turning(sketch, wheel, 84, 205, 170, "M r_2/r_1")
    sketch.ground((300, 100), (300, 180))
    sketch.mass((350, 140), 44, 60, "r_1 φ_1")
    sketch.mass((560, 140), 44, 60, "r_2 φ_2")
    sketch.dashpot((372, 120), (538, 120), "c", side=-1)
    sketch.spring((372, 160), (480, 160), "k", colour=CONTACT)
    sketch.line((480, 148), (480, 172), colour=CONTACT, width=3)
    sketch.line((490, 148), (490, 172), colour=CONTACT, width=3)
    sketch.clearance((480, 172), (490, 172), "B", offset=26, side=1)
    sketch.line((490, 160), (538, 160), colour=CONTACT)
    sketch.spring((300, 140), (328, 140), "", coils=3)
    sketch.spring((582, 140), (610, 140), "", coils=3)
    sketch.ground((610, 180), (610, 100))
    return sketch


def spinning_disc():
    sketch = Sketch("Left: a spinning disc falls on a rough floor and bounces. Right: a ball slides on a floor until it rolls")
    sketch.ground((30, 200), (300, 200))
    sketch.line((30, 200), (300, 200), colour=CONTACT, width=3)
    sketch.circle((90, 80), 36)
    turning(sketch, (90, 80), 48, 60, -20, "ω_0")
    sketch.arrow((90, 118), (90, 160))
    sketch.symbol((100, 144), "v_n", colour=MOTION, anchor="start")
    sketch.circle((225, 164), 36, fill="none", dashes="4 3")
    sketch.arrow((225, 164), (285, 164))
    sketch.symbol((292, 152), "v", colour=MOTION)
    sketch.symbol((170, 222), "μ, e", colour=CONTACT)
    sketch.ground((380, 200), (640, 200))
    sketch.line((380, 200), (640, 200), colour=CONTACT, width=3)
    sketch.circle((440, 164), 36)
    sketch.arrow((440, 164), (510, 164))
    sketch.symbol((500, 150), "v_0", colour=MOTION)
    sketch.line((440, 164), (440, 200))
    sketch.symbol((430, 184), "R", anchor="end")
    sketch.circle((575, 164), 36, fill="none", dashes="4 3")
    turning(sketch, (575, 164), 48, 60, -20, "ω")
    return sketch


def random_stop():
    sketch = Sketch("An oscillator under a random force with an elastic stop beside it")
    sketch.ground((30, 40), (30, 140))
    sketch.spring((30, 70), (130, 70), "1", side=-1)
    sketch.dashpot((30, 115), (130, 115), "c")
    sketch.mass((180, 92), 100, 76, "1")
    sketch.stop((330, 92), (280, 92), 22, ("k",))
    sketch.ground((330, 140), (330, 44))
    sketch.clearance((230, 130), (280, 130), "1", offset=40, side=1)
    heights = [0, 14, -9, 5, -16, 11, -4, 17, -12, 3, 8, -15, 6, -7, 0]
    sketch.path([(140 + 6 * i, 26 - 0.8 * height) for i, height in enumerate(heights)], colour=MOTION)
    sketch.symbol((240, 30), "w(t)", colour=MOTION, anchor="start")
    return sketch


def crushable_stop():
    sketch = Sketch("A mass on a spring with a stop that crushes; beside it the force of the stop over the penetration: a curve, and lines of unloading")
    sketch.ground((30, 40), (30, 140))
    sketch.spring((30, 90), (130, 90), "k", side=-1)
    sketch.mass((180, 90), 100, 76, "m")
    sketch.arrow((160, 30), (210, 30))
    sketch.symbol((150, 34), "F(t)", colour=MOTION, anchor="end")
    sketch.stop((330, 90), (280, 90), 22, ("",))
    sketch.ground((330, 140), (330, 40))
    sketch.clearance((230, 140), (280, 140), "c", offset=12, side=1)
    sketch.arrow((390, 150), (390, 30), colour=INK)
    sketch.arrow((380, 140), (590, 140), colour=INK)
    sketch.symbol((404, 40), "F", anchor="start")
    sketch.symbol((588, 160), "u")
    sketch.path([(390, 140), (415, 90), (500, 78), (570, 40)], colour=CONTACT, width=3)
    sketch.line((500, 78), (480, 140), colour=CONTACT, dashes="5 4")
    sketch.symbol((480, 160), "p")
    sketch.symbol((512, 112), "K", colour=CONTACT, anchor="start")
    return sketch


def overhung_rotor():
    sketch = Sketch("A shaft in two bearings with a disc behind the second one, which turns with an unbalance in a ring with clearance")
    for place in (80, 330):
        sketch.spring((place, 190), (place, 130), "k")
        sketch.ground((place - 25, 190), (place + 25, 190))
    sketch.line((60, 125), (500, 125), width=5)
    sketch.mass((505, 125), 26, 130, "m")
    sketch.circle((505, 72), 4, fill=MOTION, colour=MOTION)
    sketch.symbol((530, 66), "U", colour=MOTION, anchor="start")
    sketch.arrow((200, 100), (260, 100))
    sketch.symbol((230, 88), "Ω", colour=MOTION)
    for side, offset in ((45, 1), (205, -1)):
        sketch.line((480, side), (530, side), colour=CONTACT, width=3)
        sketch.ground((480, side - 6 * offset), (530, side - 6 * offset))
    sketch.clearance((550, 45), (550, 60), "c", offset=26, side=1)
    return sketch


SKETCHES = {"random-stop": random_stop, "crushable-stop": crushable_stop, "gear-rattle": gear_rattle, "spinning-disc": spinning_disc, "overhung-rotor": overhung_rotor}
