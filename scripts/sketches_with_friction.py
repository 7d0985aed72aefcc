"""Sketches of systems with friction, for draw-sketches.py; rubbing surfaces are red, with a short double line."""

from sketch_shapes import CONTACT, MOTION, Sketch

WALL = "#eceef1"


def rubbing(sketch, left, right, y):
    sketch.line((left, y), (right, y), colour=CONTACT, width=3)


def pressed(sketch, x, top, symbol):
    sketch.arrow((x, top - 34), (x, top))
    sketch.symbol((x + 12, top - 24), symbol, colour=MOTION, anchor="start")


def friction_oscillator():
    sketch = Sketch("Left: a mass on a spring that slides with friction under a harmonic force. Right: a mass on a spring, "
                    "carried along by a belt")
    sketch.ground((30, 40), (30, 140))
    sketch.spring((30, 95), (130, 95), "k", side=-1)
    sketch.mass((180, 95), 100, 60, "m")
    rubbing(sketch, 130, 230, 127)
    sketch.ground((60, 130), (290, 130))
    pressed(sketch, 155, 65, "N")
    sketch.symbol((180, 156), "μ", colour=CONTACT)
    sketch.arrow((232, 95), (285, 95))
    sketch.symbol((293, 95), "P sin Ωt", colour=MOTION, anchor="start")
    sketch.ground((420, 40), (420, 140))
    sketch.spring((420, 95), (500, 95), "k", side=-1)
    sketch.mass((540, 95), 80, 60, "m")
    rubbing(sketch, 500, 580, 127)
    sketch.line((450, 130), (650, 130), width=2)
    sketch.line((450, 170), (650, 170), width=2)
    for x in (450, 650):
        sketch.circle((x, 150), 20, fill="white")
    sketch.arrow((520, 150), (590, 150))
    sketch.symbol((600, 150), "V", colour=MOTION, anchor="start")
    sketch.symbol((600, 112), "μ_s, μ", colour=CONTACT, anchor="start")
    return sketch


def wear():
    sketch = Sketch("Left: a tube with hinged ends that passes between four bars in its middle. Right: the tube between the "
                    "bars, on which it strikes and rubs")
    sketch.line((60, 30), (60, 250), width=6)
    for y in (30, 250):
        sketch.path([(60, y), (46, y + 12), (74, y + 12)] if y > 100 else [(60, y), (46, y - 12), (74, y - 12)],
                    closed=True, fill="white")
    for x in (38, 82):
        sketch.line((x, 132), (x, 148), colour=CONTACT, width=5)
    sketch.symbol((96, 140), "L", anchor="start")
    centre = (260, 140)
    sketch.circle(centre, 60)
    sketch.circle(centre, 50, fill="white")
    for side in (-1, 1):
        sketch.line((260 + 72 * side, 105), (260 + 72 * side, 175), colour=CONTACT, width=4)
        sketch.line((225, 140 + 72 * side), (295, 140 + 72 * side), colour=CONTACT, width=4)
    sketch.clearance((320, 140), (332, 140), "Δ", offset=58, side=1)
    sketch.symbol((340, 96), "k, μ", colour=CONTACT, anchor="start")
    sketch.arrow((260, 140), (286, 122))
    sketch.symbol((262, 156), "F_0", colour=MOTION)
    return sketch


def building(sketch, left, right, symbols):
    """Three storeys with a brace and its damper in each; `symbols` of the storeys' stiffness and the floors' mass."""
    for i, top in enumerate((190, 120, 50)):
        for x in (left, right):
            sketch.line((x, top), (x, top + 70), width=3)
        sketch.line((left + 8, top + 64), ((left + right) / 2 - 10, top + 20), width=1.5)
        sketch.line(((left + right) / 2 - 22, top + 20), ((left + right) / 2 + 22, top + 20), colour=CONTACT, width=4)
        sketch.line(((left + right) / 2 + 10, top + 20), (right - 8, top + 64), width=1.5)
        sketch.line((left - 6, top), (right + 6, top), width=7)
    sketch.symbol(((left + right) / 2, 34), symbols)


def damped_buildings():
    sketch = Sketch("Two buildings of three storeys side by side on shaking ground, in each storey a brace with a friction "
                    "damper")
    building(sketch, 40, 140, "m, k")
    building(sketch, 176, 276, "M, K")
    sketch.ground((20, 260), (300, 260))
    sketch.clearance((146, 50), (170, 50), "Δ", offset=-26, side=-1)
    sketch.symbol((316, 140), "N (slip load)", colour=CONTACT, anchor="start")
    sketch.arrow((120, 290), (200, 290), both=True)
    sketch.symbol((212, 290), "x_0(t)", colour=MOTION, anchor="start")
    return sketch


def bolted_joint():
    sketch = Sketch("Two flat bars, one on the other in a lap with a bolt and four spring-sliders, the left one clamped, the right "
                    "one driven at its end")
    sketch.ground((40, 60), (40, 160))
    sketch.mass((160, 110), 240, 40)
    sketch.path([(200, 86), (440, 86), (440, 134), (200, 134)], closed=True, fill="#c6d4e4")
    sketch.circle((240, 110), 7, fill="white")
    for x in (205, 222, 258, 275):
        sketch.line((x, 96), (x, 124), colour=CONTACT, width=4)
    sketch.symbol((240, 160), "k_t, μN", colour=CONTACT)
    sketch.arrow((440, 110), (440, 50))
    sketch.symbol((452, 60), "P sin Ωt", colour=MOTION, anchor="start")
    return sketch


def rotor_rub():
    sketch = Sketch("Left: a disc on an elastic shaft within a stator. Right: the disc in its clearance, with an unbalance, rubbing on "
                    "the stator")
    sketch.line((60, 30), (60, 250), width=6)
    for y in (30, 250):
        sketch.path([(60, y), (46, y + 12), (74, y + 12)] if y > 100 else [(60, y), (46, y - 12), (74, y - 12)],
                    closed=True, fill="white")
    sketch.line((36, 140), (84, 140), width=10)
    for x in (26, 94):
        sketch.line((x, 128), (x, 152), colour=CONTACT, width=5)
    sketch.symbol((68, 80), "k, c", anchor="start")
    centre, disc = (260, 140), (276, 128)
    sketch.circle(centre, 80, fill="white")
    sketch.circle(disc, 58)
    sketch.line((336, 115), (336, 65), colour=CONTACT, width=4)
    sketch.symbol((346, 92), "k_s, μ", colour=CONTACT, anchor="start")
    sketch.arrow(disc, (250, 112))
    sketch.symbol((244, 106), "e", colour=MOTION)
    sketch.clearance((180, 140), (218, 140), "Δ", offset=96, side=1)
    sketch.symbol((286, 164), "Ω", colour=MOTION)
    return sketch


def steam_generator_tube():
    sketch = Sketch("Left: a tube held at both ends that passes through the holes of four plates. Right: the tube in a hole, which it "
                    "strikes and rubs")
    sketch.ground((100, 20), (20, 20))
    sketch.line((60, 20), (60, 270), width=6)
    sketch.ground((20, 270), (100, 270))
    for y in (70, 120, 170, 220):
        for left, right in ((20, 50), (70, 100)):
            sketch.line((left, y), (right, y), colour=CONTACT, width=5)
    sketch.arrow((110, 145), (66, 145))
    sketch.symbol((116, 145), "F", colour=MOTION, anchor="start")
    centre, tube = (260, 145), (276, 133)
    sketch.circle(centre, 80, fill="white")
    sketch.circle(tube, 58)
    sketch.circle(tube, 48, fill="white")
    sketch.line((336, 120), (336, 70), colour=CONTACT, width=4)
    sketch.symbol((346, 97), "k, c, μ", colour=CONTACT, anchor="start")
    sketch.clearance((180, 145), (218, 145), "Δ", offset=96, side=1)
    return sketch


def capsule():
    sketch = Sketch("A capsule on rough ground with a driven mass inside, which a spring and a dashpot hold and which meets a spring "
                    "in front")
    sketch.path([(60, 22), (430, 22), (430, 160), (60, 160)], closed=True, fill="#f4f6f9", width=2)
    sketch.symbol((410, 42), "γ")
    sketch.spring((60, 80), (180, 80), "1", side=-1)
    sketch.dashpot((60, 125), (180, 125), "2ξ", side=1)
    sketch.mass((220, 102), 80, 76, "1")
    sketch.spring((330, 102), (430, 102), "β", side=-1, colour=CONTACT)
    sketch.line((330, 86), (330, 118), colour=CONTACT, width=3)
    sketch.clearance((260, 102), (330, 102), "δ", offset=-48, side=-1)
    sketch.arrow((262, 116), (312, 116))
    sketch.symbol((262, 138), "α cos wt", colour=MOTION, anchor="start")
    rubbing(sketch, 62, 428, 163)
    sketch.ground((30, 166), (560, 166))
    sketch.arrow((436, 102), (500, 102))
    sketch.symbol((508, 102), "x_2", colour=MOTION, anchor="start")
    sketch.symbol((245, 190), "μN = 1", colour=CONTACT)
    return sketch


SKETCHES = {"rotor-rub": rotor_rub, "steam-generator-tube": steam_generator_tube, "friction-oscillator": friction_oscillator, "wear": wear, "damped-buildings": damped_buildings,
            "bolted-joint": bolted_joint, "capsule": capsule}
