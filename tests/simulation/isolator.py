"""An isolator with a two-sided elastic stop, for tests of whole runs: two steady motions between
1.231279 and 1.362748 rad/s, folds of its response at 0.195964 Hz (falling) and 0.216888 Hz (rising).
Without contact its amplitude is f / |1 - l^2 + 0.02 i l|.
"""

STOP = """
subsection Contact NAME
  set Between = mass.head
  set Direction = DIRECTION
  set Clearance = 1 m
  set Law = bilinear stop
  KEYS
  subsection Bilinear stop
    set Stiffness = STIFFNESS
    set Damping constant = 0.4 N s/m
  end
end
"""


def stops(stiffness, keys):
    """Both, `keys` being further lines of each."""
    text = STOP.replace("STIFFNESS", stiffness).replace("KEYS", keys)
    return "".join(text.replace("NAME", name).replace("DIRECTION", direction)
                   for name, direction in (("right", "x"), ("left", "-x")))


def isolator(stiffness="2 N/m", force="0.52 N", frequency="1.1 rad/s", keys=""):
    """The file of the model, without analyses; values may be those of variables."""
    return f"""
subsection Body mass
  set Type = lumped
  subsection Mass head
    set Mass = 1 kg
    set Stiffness = 1 N/m
    set Damping = 0.02 N s/m
  end
end
{stops(stiffness, keys)}
subsection Excitation push
  set Type = force
  set At = mass.head
  set Amplitude = {force}
  set Frequency = {frequency}
end
"""
