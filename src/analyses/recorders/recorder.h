// What is kept of a motion while it is recorded: extreme values, statistics, impacts, sections,
// spectra, character, ... Each recorder is one file pair in recorders/ and one line in
// recorders.cc.
//
// An analysis that lets a motion settle and then watches it hands the window to a WindowRecording
// (window_recording.h): it creates the recorders that the key Record names, tells them where the
// window begins, integrates one forcing period after the other (so that a state is exact at each
// period's end), tells them where it ends, and lets them turn what they saw into fields.
#pragma once

#include "analyses/recorders/observables.h"
#include "analyses/results/field_writer.h"
#include "analyses/run/system.h"
#include "motion/interval/extremum.h"
#include "motion/path/trajectory.h"

#include <functional>
#include <memory>

namespace vibroimpact::analyses {

/// The part of a motion that is recorded.
struct Window {
  double start = 0;  ///< [s]
  double end = 0;    ///< [s]
  double period = 0; ///< of the excitation [s]; 0 when the window is not divided into periods
  long cycles = 0;   ///< periods in the window; 0 when it is not divided

  double length() const { return end - start; }
};

enum class Bound { largest, smallest };

/// An extreme value of what is linear in the motion, or of a force; of the smallest value with the
/// sign reversed.
struct ObservedExtremum {
  const motion::Extremum *extremum = nullptr;
  Observable observed;
  Bound bound = Bound::largest;
};

struct TangentMotion;

class Recorder : public motion::Observer {
public:
  /// A window begins: the trajectory stands at its start. A recorder serves many windows one after
  /// the other and forgets the one before here.
  virtual void begin(const Window & /*window*/, const motion::Trajectory & /*trajectory*/) {}
  /// The trajectory stands exactly at the end of forcing period `cycle` (1, 2, ... Window::cycles).
  virtual void period_end(long /*cycle*/, const motion::Trajectory & /*trajectory*/) {}
  /// The window is over: the trajectory stands at its end. Called after all period_end().
  virtual void end(const motion::Trajectory & /*trajectory*/) {}

  /// Fields and summary lines of what was seen between the window's start and its end. Recorders
  /// of cheap points make the labels of their fields when they are made.
  virtual void add_fields(const FieldWriter &result) const = 0;

  /// Has it derivatives by keys of its own? Before the first window; from now on it keeps what they
  /// need.
  virtual bool keeps_extrema() { return false; }
  /// Behind the window: what is to be differentiated for add_tangents(). The extrema stay where
  /// they are.
  virtual std::vector<ObservedExtremum> extrema() const { return {}; }
  /// Derivatives by a key under the labels of its fields. What it leaves out is differenced between
  /// neighbouring motions.
  virtual void add_tangents(const TangentMotion & /*motion*/,
                            const FieldWriter & /*result*/) const {}
};

/// Makes a recorder of the points of an analysis. The system outlives the recorder. InputError
/// when the options do not fit the system.
using RecorderFactory = std::function<std::unique_ptr<Recorder>(const System &system)>;

/// A kind of recorder as the parameter file knows it.
struct RecorderKind {
  const char *name;        ///< as in the key Record: "extreme values"
  const char *description; ///< a few words for the manual: "extreme values"
  /// Declares the subsection of its options in the section of the analysis, or nothing.
  void (*declare)(parameters::Section &analysis);
  /// Reads the options. InputError when they cannot be used.
  RecorderFactory (*create)(const parameters::Values &analysis);
};

} // namespace vibroimpact::analyses
