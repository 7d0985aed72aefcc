// Every way in which a .prm file can be wrong, with the whole message.
#include "sample.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace vibroimpact::parameters {
namespace broken_files_tests {

struct Case {
  const char *name;
  const char *text;
  const char *message; ///< behind "params/beams.prm:"
};

void PrintTo(const Case &broken, std::ostream *out) { *out << broken.name; }

class BrokenFilesTable : public ::testing::TestWithParam<Case> {};

TEST_P(BrokenFilesTable, is_refused_with_place_and_reason) {
  EXPECT_EQ(error_of([] { parse_prm(GetParam().text); }),
            std::string("params/beams.prm:") + GetParam().message);
}

const std::vector<Case> structure{
    {"unknown_key", "set Titel = x\n",
     "1: Titel = x\n  there is no key 'Titel' here; did you mean 'Title'?"},
    {"unknown_key_far", "set Colour = x\n",
     "1: Colour = x\n  there is no key 'Colour' here; possible are: Variables, Units, Title, "
     "Bodies."},
    {"key_of_a_subsection", "subsection Body a\n  set Elements = 3\nend\n",
     "2: Body a / Elements = 3\n  there is no key 'Elements' here; it belongs into the subsection "
     "'Geometry'."},
    {"unknown_subsection", "\nsubsection Excitaton\nend\n",
     "2: Excitaton\n  there is no subsection 'Excitaton' here; did you mean 'Excitation'?"},
    {"unknown_kind", "subsection Contct heads\nend\n",
     "1: Contct heads\n  there is no subsection 'Contct heads' here; did you mean 'Contact "
     "heads'?"},
    {"unknown_subsection_far", "subsection Something\nend\n",
     "1: Something\n  there is no subsection 'Something' here; possible are: Excitation, Body "
     "NAME, "
     "Contact NAME."},
    {"kind_without_name", "subsection Body\nend\n",
     "1: Body\n  a name is missing; write 'subsection Body NAME'."},
    {"bad_instance_name", "subsection Body left.1\nend\n",
     "1: Body left.1\n  'left.1' cannot be a name: use letters, digits, '_' and '-'."},
    {"instance_name_of_two_words", "subsection Body left one\nend\n",
     "1: Body left one\n  'left one' cannot be a name: use letters, digits, '_' and '-'."},
    {"duplicate_key", "set Title = a\n# x\nset Title = b\n",
     "3: Title = b\n  this key is set twice; first at params/beams.prm:1."},
    {"duplicate_instance", "subsection Body a\nend\nsubsection Body a\nend\n",
     "3: Body a\n  this subsection stands here twice; first at params/beams.prm:1."},
    {"duplicate_section", "subsection Excitation\nend\nsubsection Excitation\nend\n",
     "3: Excitation\n  this subsection stands here twice; first at params/beams.prm:1."},
    {"missing_end", "set Title = a\nsubsection Body a\n  subsection Geometry\n  end\n",
     "2: Body a\n  this subsection is not closed: its 'end' is missing."},
    {"missing_inner_end", "subsection Body a\n  subsection Geometry\n",
     "2: Body a / Geometry\n  this subsection is not closed: its 'end' is missing."},
    {"surplus_end", "subsection Body a\nend\nend\n",
     "3\n  this 'end' closes nothing: no subsection is open here."},
    {"garbage", "subsection Body a\n  hello world\nend\n",
     "2: Body a\n  'hello world' cannot be read: a line is 'subsection NAME', 'set KEY = VALUE', "
     "'include FILE', 'end', or a comment that begins with '#'."},
    {"set_missing", "Title = a\n",
     "1\n  'Title = a' cannot be read: 'set' is missing; write 'set Title = a'."},
    {"equals_missing", "set Title a\n",
     "1\n  'set Title a' cannot be read: '=' is missing; write 'set KEY = VALUE'."},
    {"key_missing", "set = a\n", "1\n  a key is missing between 'set' and '='."},
    {"subsection_without_name", "subsection\nend\n",
     "1\n  'subsection' cannot be read: a name is missing after it."},
    {"continued_comment", "set Title = a # why \\\nset Bodies = b\n",
     "1\n  a comment cannot be continued by '\\': the next line would be lost."},
    {"continued_end_of_file", "set Title = a \\",
     "1\n  the last line ends in '\\', but no line follows."},
    {"missing_include", "set Title = a\ninclude nowhere.prm\n",
     "2\n  the file 'params/nowhere.prm' does not exist."},
    {"key_as_section", "subsection Title\nend\n",
     "1: Title\n  'Title' is a key, not a subsection."},
    {"another_encoding", "set Title = M\xFCller\n",
     "1\n  this line holds a character that is no text, such as a NUL byte or a letter in another "
     "encoding than UTF-8."},
    {"half_a_character", "set Title = M\xC3\n",
     "1\n  this line holds a character that is no text, such as a NUL byte or a letter in another "
     "encoding than UTF-8."},
    {"beyond_the_last_character", "set Title = \xF5\x80\x80\x80\n",
     "1\n  this line holds a character that is no text, such as a NUL byte or a letter in another "
     "encoding than UTF-8."},
    {"name_listed_twice", "set Bodies = a, b, a\n",
     "1: Bodies = a, b, a\n  'a' is listed twice; different names separated by commas are "
     "expected."},
    {"section_as_key", "set Excitation = 3\n",
     "1: Excitation = 3\n  'Excitation' is a subsection, not a key with a value."},
};
INSTANTIATE_TEST_SUITE_P(Structure, BrokenFilesTable, ::testing::ValuesIn(structure),
                         [](const auto &info) { return std::string(info.param.name); });

const std::vector<Case> values{
    {"wrong_dimension", "subsection Contact heads\n  set Clearance = 5 kg\nend\n",
     "2: Contact heads / Clearance = 5 kg\n  '5 kg' is a mass [kg]; a length [m] is expected "
     "(greater than or equal to 0), for example 0 m."},
    {"zero_of_wrong_dimension", "subsection Contact heads\n  set Clearance = 0 kg\nend\n",
     "2: Contact heads / Clearance = 0 kg\n  '0 kg' is a mass [kg]; a length [m] is expected "
     "(greater than or equal to 0), for example 0 m."},
    {"out_of_range", "subsection Contact heads\n  set Stiffness = -3 kN/m\nend\n",
     "2: Contact heads / Stiffness = -3 kN/m\n  '-3 kN/m' is out of range; a stiffness [N/m] is "
     "expected (greater than 0), for example 10 kN/m."},
    {"expression_out_of_range",
     "set Variables = k = -2\nsubsection Contact heads\n  set Stiffness = k * 1 kN/m\nend\n",
     "3: Contact heads / Stiffness = k * 1 kN/m\n  'k * 1 kN/m', which is -2000 N/m, is out of "
     "range; a stiffness [N/m] is expected (greater than 0), for example 10 kN/m."},
    {"above_range",
     "subsection Body a\n  subsection Modes\n    set Damping ratio = 1.5\n  end\nend\n",
     "3: Body a / Modes / Damping ratio = 1.5\n  '1.5' is out of range; a pure number [1] is "
     "expected (from 0 to 1), for example 1 %."},
    {"bare_frequency", "subsection Excitation\n  set Frequency = 3\nend\n",
     "2: Excitation / Frequency = 3\n  '3' has no unit; a frequency must say Hz, kHz, MHz, rad/s "
     "or "
     "rpm; a frequency [rad/s] is expected (greater than 0), for example 3 Hz."},
    {"inverse_time_as_frequency", "subsection Excitation\n  set Frequency = 3/s\nend\n",
     "2: Excitation / Frequency = 3/s\n  '3/s' is an inverse time [1/s]; a frequency must say Hz, "
     "kHz, MHz, rad/s or rpm; a frequency [rad/s] is expected (greater than 0), for example 3 Hz."},
    {"unknown_unit", "subsection Contact heads\n  set Clearance = L / 2\nend\n",
     "2: Contact heads / Clearance = L / 2\n  'L / 2' holds 'L', which is neither a unit nor a "
     "variable; a length [m] is expected (greater than or equal to 0), for example 0 m."},
    {"not_a_number", "subsection Contact heads\n  set Clearance = nan\nend\n",
     "2: Contact heads / Clearance = nan\n  'nan' holds 'nan', which is neither a unit nor a "
     "variable; a length [m] is expected (greater than or equal to 0), for "
     "example 0 m."},
    {"division_by_zero", "subsection Contact heads\n  set Clearance = 1 m / 0\nend\n",
     "2: Contact heads / Clearance = 1 m / 0\n  '1 m / 0' is not a finite number; a length [m] is "
     "expected (greater than or equal to 0), for example 0 m."},
    {"mixed_dimensions", "subsection Contact heads\n  set Clearance = 1 m + 1 s\nend\n",
     "2: Contact heads / Clearance = 1 m + 1 s\n  '1 m + 1 s' adds or compares different "
     "dimensions, "
     "or has a unit in a function's argument or exponent; a length [m] is expected (greater than "
     "or equal to 0), for example 0 m."},
    {"empty_value", "subsection Contact heads\n  set Clearance =\nend\n",
     "2: Contact heads / Clearance = \n  a value is missing; a length [m] is expected (greater "
     "than "
     "or equal to 0), for example 0 m."},
    {"list_too_short",
     "subsection Body a\n  subsection Geometry\n    set Start = 0, 1 m\n  end\nend\n",
     "3: Body a / Geometry / Start = 0, 1 m\n  the number of values is 2; separated by commas, 3 "
     "values are expected, each a length [m], for example 0, 0, 0."},
    {"list_entry_empty",
     "subsection Body a\n  subsection Geometry\n    set Start = 0,,1\n  end\nend\n",
     "3: Body a / Geometry / Start = 0,,1\n  an entry of the list is empty; separated by commas, 3 "
     "values are expected, each a length [m], for example 0, 0, 0."},
    {"list_entry_wrong",
     "subsection Body a\n  subsection Geometry\n    set Start = 0,1 s,1\n  end\nend\n",
     "3: Body a / Geometry / Start = 0,1 s,1\n  '1 s' is a time [s]; a length [m] is expected, for "
     "example 5 mm."},
    {"fraction_as_integer",
     "subsection Body a\n  subsection Geometry\n    set Elements = 2.5\n  end\nend\n",
     "3: Body a / Geometry / Elements = 2.5\n  '2.5' is not a whole number; a whole number is "
     "expected (from 1 to 1e+06), for example 40."},
    {"integer_with_unit",
     "subsection Body a\n  subsection Geometry\n    set Elements = 2 m\n  end\nend\n",
     "3: Body a / Geometry / Elements = 2 m\n  '2 m' is not a whole number; a whole number is "
     "expected (from 1 to 1e+06), for example 40."},
    {"integer_out_of_range",
     "subsection Body a\n  subsection Geometry\n    set Elements = 0\n  end\nend\n",
     "3: Body a / Geometry / Elements = 0\n  '0' is out of range; a whole number is expected (from "
     "1 "
     "to 1e+06), for example 40."},
    {"integer_word",
     "subsection Body a\n  subsection Geometry\n    set Elements = many\n  end\nend\n",
     "3: Body a / Geometry / Elements = many\n  'many' holds 'many', which is neither a unit nor a "
     "variable; a whole number is expected (from 1 to 1e+06), for example 40."},
    {"boolean", "subsection Contact heads\n  set Prestressed = maybe\nend\n",
     "2: Contact heads / Prestressed = maybe\n  'maybe' is not possible; true or false is expected "
     "(or yes, no, on, off)."},
    {"choice", "subsection Body a\n  set Type = shel\nend\n",
     "2: Body a / Type = shel\n  'shel' is not possible; did you mean 'shell'? one of these is "
     "expected: beam, shell, lumped."},
    {"names", "set Bodies = a,,b\n",
     "1: Bodies = a,,b\n  an entry of the list is empty; different names separated by commas are "
     "expected."},
    {"variable_named_as_unit", "set Variables = g = 3\n",
     "1: Variables = g = 3\n  'g' is a unit and cannot be the name of a variable."},
    {"variable_named_as_function", "set Variables = sqrt = 3\n",
     "1: Variables = sqrt = 3\n  'sqrt' is a function or constant and cannot be the name of a "
     "variable."},
    {"variable_twice", "set Variables = a = 3, a = 4\n",
     "1: Variables = a = 3, a = 4\n  the variable 'a' is defined twice."},
    {"variable_without_value", "set Variables = a\n",
     "1: Variables = a\n  'a' defines nothing; NAME = VALUE is expected, separated by commas."},
    {"variable_used_before_definition", "\nset Variables = a = 2 * b, b = 3\n",
     "2: Variables = a = 2 * b\n  '2 * b' holds 'b', which is neither a unit nor a variable."},
    {"first_in_file_order",
     "subsection Contact c\n  set Clearance = 1 kg\nend\nsubsection Body a\n  set Type = x\nend\n",
     "2: Contact c / Clearance = 1 kg\n  '1 kg' is a mass [kg]; a length [m] is expected (greater "
     "than or equal to 0), for example 0 m."},
};
INSTANTIATE_TEST_SUITE_P(Content, BrokenFilesTable, ::testing::ValuesIn(values),
                         [](const auto &info) { return std::string(info.param.name); });

std::string read_error(const std::string &file) {
  return error_of([&] { ParameterSet::read(sample_declarations(), file); });
}

TEST(BrokenFiles, missing_file_wrong_suffix_and_folder) {
  EXPECT_EQ(read_error("nowhere.prm"), "nowhere.prm\n  the file 'nowhere.prm' does not exist.");
  EXPECT_EQ(read_error("beams.txt"),
            "beams.txt\n  the name of a parameter file must end in .prm or .json.");
  const std::string folder = ::testing::TempDir() + "/folder.prm";
  std::filesystem::create_directories(folder);
  EXPECT_EQ(read_error(folder), folder + "\n  '" + folder + "' is not a file.");
}

TEST(BrokenFiles, a_file_that_includes_itself) {
  const std::string file = (std::filesystem::path(::testing::TempDir()) / "circle.prm").string();
  std::ofstream(file) << "set Title = a\ninclude circle.prm\n";
  EXPECT_EQ(read_error(file),
            file + ":2\n  the file includes itself: " + file + " -> " + file + ".");
}

TEST(BrokenFiles, a_message_carries_no_stack_trace) {
  for (const Case &broken : structure)
    EXPECT_EQ(error_of([&] { parse_prm(broken.text); }).find("Stacktrace"), std::string::npos);
}

TEST(BrokenFiles, a_nul_byte_is_refused_at_its_line) {
  const std::string text("set Title = a\nset Bodies = b\0c\n", 30);
  EXPECT_EQ(error_of([&] { parse_prm(text); }).substr(0, 65),
            "params/beams.prm:2\n  this line holds a character that is no text,");
  EXPECT_NO_THROW(parse_prm("# M\xFCller\nset Title = M\xC3\xBCller \xF0\x9F\x94\xA7\n"));
}

// Each level is a call of the destructor of another.
TEST(BrokenFiles, endless_nesting_is_refused) {
  std::string text;
  for (int i = 0; i < 100000; ++i)
    text += "subsection Body a\n";
  EXPECT_EQ(error_of([&] { parse_prm(text); }),
            "params/beams.prm:51\n  subsections nest more than 50 deep.");
}

TEST(BrokenFiles, messages_stay_short) {
  const std::string many(20000, 'x');
  for (const std::string &text :
       {"set Title = a\nset " + many + " = 1\n", "subsection " + many + "\nend\n",
        "subsection Contact heads\n  set Clearance = " + many + "\nend\n",
        "subsection Body a\n  set Type = " + many + "\nend\n", many + "\n"}) {
    const std::string message = error_of([&] { parse_prm(text); });
    EXPECT_GT(message.size(), 100U);
    EXPECT_LT(message.size(), 2500U) << message;
    EXPECT_NE(message.find("xxx ... "), std::string::npos) << message;
  }
  // Cut between characters, not within one.
  std::string letters;
  for (int i = 0; i < 3000; ++i)
    letters += "\xC3\xBC";
  for (const std::string before : {"", "a"})
    EXPECT_NO_THROW(parse_prm("# ok\nset Title = " + before + letters + "\n"));
  const std::string message =
      error_of([&] { parse_prm("subsection Body a\n  set Type = a" + letters + "\nend\n"); });
  EXPECT_NE(message.find("\xC3\xBC ... \xC3\xBC"), std::string::npos) << message;
}

} // namespace broken_files_tests
} // namespace vibroimpact::parameters
