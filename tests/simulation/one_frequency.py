"""The amplitude of a linear response at one frequency as a single number, for tests of searches and
fits.
"""


def amplitude_at(analysis, frequency, derived, field):
    """An analysis of one frequency and the quantity derived from it."""
    return f"""
subsection Analysis {analysis}
  set Type = frequency response
  subsection Frequency response
    set First frequency = {frequency}
    set Last frequency = {frequency}
    set Points = 1
  end
end
subsection Derived {derived}
  set From = {analysis}
  set Operation = maximum
  set Field = {field}
  set Along = frequency
end
"""
