// The arithmetic of exact propagation: plain arrays in, plain arrays out.
//
// In a linear phase all that matters is a sum of groups: complex exponentials (pairs), real ones,
// and columns of dense blocks, whose coordinates x obey x' = B x. A guard over a piece of length h,
// with tau = t / h in [0, 1], is
//
//   f(tau) = constant + sum over groups of Re(c_j a_j exp(e_j h tau))
//
// and each exponential has been tabulated as a polynomial of degree 7 in Bernstein form over the
// lengths h_k = h_0 2^(-k/2): value, slope and curvature are right at tau = 0, the value at five
// more points. The Bernstein coefficients of a guard are a sum of table columns times amplitudes;
// they bound the polynomial, and with the error E of the interpolation they prove that the guard
// stays positive, or changes sign once, in the piece.
//
//   |f - p| / tau^r <= K_r |c a| |e h|^8 max(1, exp(rho h)),  K = 2.371e-9, 1.371e-8, 1.104e-7
//
// (r = 0, 1, 2): the remainder f^(8)/8! tau^3 (tau - tau_1) ... (tau - tau_5) has the factor tau^3,
// so that a guard with a zero of order r at tau = 0 can be divided by tau^r and be judged the same
// way.
//
// These structures hold pointers only: the files that are compiled for different machines share no
// function that could be linked from the wrong one.
#pragma once

namespace vibroimpact::motion {

/// Arrays over groups are padded by zeros to a multiple of this.
constexpr int group_block = 8;
/// Order of the largest zero that a guard may start from.
constexpr int largest_order = 2;
constexpr int table_degree = 7;
constexpr int n_levels = 96;
/// How often a part is halved in the search for extreme values.
constexpr int most_halvings = 60;
/// Pieces of a phase whose length is remembered.
constexpr int n_hints = 8;

/// What rounding may hide of a guard, relative to the sum of the sizes of its terms: several times
/// what sums of hundreds of terms, in blocks of eight, and of their exponentials lose (Higham 2002,
/// section 4.2).
constexpr double guard_rounding = 32 * 0x1p-52;

/// Of sines and cosines that the kernel takes.
constexpr double largest_angle = 1e5;

/// Consecutive groups that form one block, x' = B x.
struct DenseBlockView {
  int first = 0, size = 0;
  const double *generator = nullptr; ///< B, size x size, row by row [1/s]
};

/// A guard that is a sum of squares of three linear forms f: scale (f_0^2 - f_1^2 - f_2^2).
struct SquaresView {
  int first = 0; ///< f_0 among the forms, the others behind it; 0: the guard is a form itself
  double scale = 0;
};

/// All that belongs to pieces of one length. Null pointers: not made yet.
struct LevelView {
  double length = 0;            ///< h [s]
  const double *turn = nullptr; ///< real, then imaginary parts of exp(e h), by groups
  /// bound of the growth of each group's magnitude within the piece; of dense blocks exp(|B| h),
  /// entry by entry, which bounds exp(B t) likewise
  const double *growth = nullptr, *dense_growth = nullptr;
  const double *table = nullptr;  ///< forms x (groups, then pairs) x 8 Bernstein coefficients
  const double *bounds = nullptr; ///< forms x orders x groups: of |f - p| / tau^r by magnitude
  const double *dense = nullptr;  ///< exp(B h) of the dense blocks
};

/// The first forms are the guards, but for those that are sums of squares of later ones.
struct PhaseView {
  int n_groups = 0, n_padded = 0, n_guards = 0, n_forms = 0;
  int n_pairs = 0; ///< the first groups have an imaginary part
  int n_dense = 0;
  const DenseBlockView *dense = nullptr;
  const double *rate = nullptr, *frequency = nullptr; ///< real and imaginary parts of e [1/s]
  /// forms x 4 x 2 x groups: the coefficients of real and imaginary parts of the amplitudes in f
  /// and its first three derivatives
  const double *rows = nullptr;
  const double *sizes = nullptr; ///< forms x groups: what c was summed up from
  /// forms x groups: bounds of the first three derivatives
  const double *slopes = nullptr, *second = nullptr, *third = nullptr;
  const double *constants = nullptr, *constant_sizes = nullptr; ///< forms
  const SquaresView *squares = nullptr; ///< guards; null: all of them are forms
  const double *weights = nullptr;      ///< groups: of the size of all guards, then of their error
  double constant_weight = 0;
  double fastest = 0; ///< largest |e| [1/s]
  LevelView *levels = nullptr;
  signed char *hints = nullptr;
  /// Makes a level that is missing.
  void (*make_level)(void *owner, int level) = nullptr;
  void *owner = nullptr;
};

/// Linear forms of the motion whose extreme values are wanted; in blocks of eight, padded.
struct OutputsView {
  int n_blocks = 0;
  const double *constants = nullptr; ///< outputs
  /// blocks x 3 x 2 x groups x 8: coefficients in value, slope and curvature
  const double *rows = nullptr;
  const double *sixth = nullptr; ///< blocks x groups x 8: bound of the sixth derivative
  const double *sizes = nullptr; ///< blocks x groups x 8: |c|
  /// outputs x 4 x 2 x groups: the same coefficients, and those of the third derivative
  const double *single = nullptr;
  const double *dense_magnitudes = nullptr;      ///< |B| of the dense blocks, like them
  double *minimum = nullptr, *maximum = nullptr; ///< outputs; grow
  double *middles = nullptr;                     ///< scratch: most_halvings x 2 x groups
  double *turned = nullptr;                      ///< scratch: 2 x groups
  double *reach = nullptr;                       ///< scratch: groups
  long pieces = 0;                               ///< of parts, examined so far
};

struct MarchState {
  double *amplitudes = nullptr;   ///< real, then imaginary parts
  const double *origin = nullptr; ///< the same when `time` was 0
  double *turned = nullptr;       ///< the same a little later; scratch, and those at a crossing
  double *magnitudes = nullptr;   ///< scratch: groups, |real| + |imaginary|
  double *reach = nullptr;        ///< scratch: groups, bound of that within a piece
  const double *noise = nullptr;  ///< forms: rounding of the amplitudes, as it shows in each
  unsigned char *order = nullptr; ///< guards: of their zero at the start
  double tolerated = 1e-4;        ///< error of a piece, relative to the sizes of the guards
  double time = 0;                ///< since the start [s]
  int pieces_of_phase = 0;
  long pieces = 0;
  long undecided = 0; ///< touches that rounding hides
  // A crossing:
  int guard = 0;
  double to_guard = 0; ///< [s] from `time`
  double value = 0, slope = 0;
};

enum class MarchEnd {
  limit,  ///< nothing happened
  paused, ///< many pieces later; to be called again
  guard,  ///< a guard is zero `to_guard` from here; `turned` are the amplitudes there
  unclear ///< what happens cannot be proven
};

/// A phase change, amplitudes to amplitudes.
struct ChangeView {
  int n_columns = 0;                  ///< real coordinates of the old phase
  const int *places = nullptr;        ///< of each in its amplitudes, the imaginary parts behind
  int n_padded = 0;                   ///< groups of the new phase
  const double *constant = nullptr;   ///< 2 x groups
  const double *columns = nullptr;    ///< columns x 2 x groups
  const double *magnitudes = nullptr; ///< columns x groups: what the columns were summed up from
  const double *constant_sizes = nullptr; ///< groups
};

/// A product of two exponentials of a phase, or of one and the conjugate of the other.
struct ProductView {
  int first = 0, second = 0; ///< groups
  bool conjugate = false;
  bool is_slow = false;                   ///< by the trapezoidal rule
  double sum_real = 0, sum_imaginary = 0; ///< of the exponents [1/s]
};

/// Integrals of quadratic forms of the amplitudes; see work_integrals.h.
struct WorkView {
  int n_products = 0, n_padded = 0, n_blocks = 0; ///< blocks of eight integrals
  const ProductView *products = nullptr;
  /// blocks x products x 2 x 8: real and imaginary parts of the coefficients
  const double *coefficients = nullptr;
};

/// One set of functions for each kind of machine.
struct Kernel {
  const char *name;
  /// Goes on to `limit` [s after the start of the walk] or to the first crossing.
  MarchEnd (*advance)(const PhaseView &phase, MarchState &walk, double limit);
  /// The amplitudes `time` later.
  void (*turn)(const PhaseView &phase, const double *amplitudes, double time, double *turned);
  /// The extremes grow by the motion between two instants, `length` apart [s].
  void (*include_part)(const PhaseView &phase, OutputsView &outputs, const double *from,
                       const double *to, double length);
  /// Value and first three derivatives of a guard, or of a form behind the guards.
  void (*derivatives)(const PhaseView &phase, int guard, const double *amplitudes, double *values);
  /// What rounding may hide of a guard, `noise` (forms) being that of the amplitudes.
  double (*guard_margin)(const PhaseView &phase, int guard, const double *amplitudes,
                         const double *noise);
  /// What the rounding of the amplitudes (n_padded) makes of each form.
  void (*form_noise)(const PhaseView &phase, const double *rounding, double *noise);
  /// `rounding`: n_padded, of the amplitudes.
  void (*change)(const ChangeView &change, const double *from, double *to, double *rounding);
  /// The integrals from one instant to another, `length` later [s]; all n_blocks x 8 of them.
  void (*integrate)(const WorkView &work, const double *from, const double *to, double length,
                    double *integrals);
  /// exp, cos and sin of eight numbers; for tests.
  void (*exponential)(const double *x, double *result);
  void (*sine_cosine)(const double *x, double *sines, double *cosines);
};

/// The fastest that this machine has; the environment variable VIBROIMPACT_KERNEL may name another
/// (avx512, avx2, plain). std::runtime_error when that one cannot run here.
const Kernel &kernel();

extern const Kernel kernel_avx512, kernel_avx2, kernel_plain;
bool machine_has(const Kernel &kernel);

/// exp(B t) x of a dense block; from and to may be the same.
void turn_dense_block(const double *generator, int size, double time, const double *from,
                      double *to);

} // namespace vibroimpact::motion
