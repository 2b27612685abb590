/// Texts that would be commands in gnuplot, a shell or a browser are drawn and shown as texts.
#include <algorithm>
#include <filesystem>
#include <string_view>
#include <vector>

#include "run_driver.hpp"
#include "support/gnuplot.hpp"

namespace hostile_text_test {
namespace {

namespace fs = std::filesystem;
using driver::gnuplot_text;
using driver::Markup;

/// What would make a file, end a string or a line, or take a place in markup.
const std::vector<std::string> hostile{
    "`touch pwned`",
    "a\n!touch pwned\nb",
    "a\r!touch pwned\rb\nsystem 'touch pwned'\n",
    "' . system('touch pwned') . '",
    "'; system 'touch pwned'; set title '",
    "\" . system(\"touch pwned\") . \"`touch pwned`\"",
    "a'' . system('touch pwned') . ''b'",
    "'",
    "@touch <touch pwned |touch pwned %s%n%d $(touch pwned) ${pwned} # \\",
    "<touch pwned",
    "|touch pwned",
    "\x1b]0;x\x07\t\x7f\xc2\x9b\xe2\x80\xa8!touch pwned",
    "{{{}_{^}& ~ @ {/Sans\"><evil x} }<evil onload=\"touch\"> &lt; {}",
    "p_{max} \\_ {/Sans\"><evil x} {x",
    "\\",
    std::string(3000, '{') + "^_" + std::string(3000, '}'),
    std::string(3000, '^')};

/// As a text of TOML.
std::string toml(const std::string& text) {
  std::string out = "\"";
  for (const char letter : text) {
    constexpr unsigned char blank = ' ';
    constexpr const char* digits = "0123456789abcdef";
    const auto byte = static_cast<unsigned char>(letter);
    if (byte < blank || byte == 0x7F) {
      out += std::string("\\u00") + digits[byte / 16] + digits[byte % 16];
    } else {
      out += (letter == '"' || letter == '\\' ? "\\" : "") + std::string(1, letter);
    }
  }
  return out + '"';
}

/// For a shell.
std::string shell(const std::string& text) {
  std::string out = "'";
  for (const char letter : text) {
    out += letter == '\'' ? "'\\''" : std::string(1, letter);
  }
  return out + '\'';
}

/// Besides ends of lines: a terminal would obey them.
bool has_control_characters(const std::string& text) {
  return std::any_of(text.begin(), text.end(), [](unsigned char letter) {
    return (letter < 0x20 && letter != '\n') || letter == 0x7F;
  });
}

/// As the name of a file in this folder.
std::string file_name(std::string text) {
  std::erase(text, '/');
  constexpr std::size_t most = 150; // bytes; another 50 for what is added
  return text.substr(0, most);
}

class HostileText : public Driver {
protected:
  /// No command was run.
  void expect_no_trace() const {
    for (const auto& entry : fs::recursive_directory_iterator(folder())) {
      EXPECT_NE(entry.path().filename(), "pwned");
    }
  }
  void expect_pictures(std::size_t count) const {
    std::size_t found = 0;
    for (const auto& entry : fs::recursive_directory_iterator(folder())) {
      const std::string name = fs::relative(entry.path(), folder()).string();
      if (name.ends_with(".svg")) {
        const std::string picture = read(name);
        EXPECT_TRUE(is_svg(name) && picture.ends_with("</svg>\n\n")) << name;
        EXPECT_EQ(picture.find("<evil"), std::string::npos) << name;
        EXPECT_EQ(picture.find("Sans\"><"), std::string::npos) << name;
        ++found;
      } else if (name.ends_with(".png")) {
        EXPECT_TRUE(is_png(name)) << name;
        ++found;
      }
    }
    EXPECT_EQ(found, count);
  }
  void clear() const {
    fs::remove_all(folder());
    fs::create_directories(folder());
  }
  /// A wheel in a file of this name.
  void write_wheel(const std::string& name) const {
    if (!exists("wheel.dat")) {
      ASSERT_EQ(run(WRC_PROFILE_PROGRAM, "S1002 --convert wheel.dat").exit_code, 0);
    }
    fs::copy_file(folder() / "wheel.dat", folder() / name, fs::copy_options::overwrite_existing);
  }
};

/// All fields of all kinds of pictures, and the names of all files.
std::string study_of(const std::string& text) {
  const std::string wheel = toml(file_name(text) + ".txt; origin = tape");
  const std::string any = toml(text);
  const std::string with_value = toml(text + "{wheelset.right.wheel}{}");
  const std::string labels = ", title = " + with_value + ", x_label = " + any;
  const std::string by_wheel = ", series = \"wheelset.left.wheel\", series_label = " + with_value;
  const std::string panels = ", panels = [{y_label = " + any +
                             ", lines = [{result = "
                             "\"rolling_radius_difference\", title = " +
                             any + "}]}]";
  std::string pictures;
  const auto add = [&](const std::string& kind, const std::string& more) {
    const std::string file = toml(file_name(text) + kind + (kind == "lines" ? ".png" : ".svg"));
    pictures += (pictures.empty() ? "{kind = \"" : ", {kind = \"") + kind + "\", file = " + file +
                ", x = \"pose.lateral\"" + labels + more + '}';
  };
  add("lines", by_wheel + panels);
  add("map", ", series = \"pose.yaw\", series_label = " + any + panels);
  add("patches", by_wheel);
  add("connections", "");
  add("conicity", by_wheel);
  add("ranking", ", series = [\"wheelset.left.wheel\", \"pose.yaw\"]" + panels);
  std::string results;
  for (const char* side : {"left", "right"}) {
    for (const char* name :
         {"pmax", "rigid_contact.y", "rigid_contact.z", "rigid_contact.s_wheel",
          "rigid_contact.w_wheel", "rigid_contact.rolling_radius", "rigid_contact.angle"}) {
      results += std::string("\"") + side + '.' + name + "\", ";
    }
  }
  return "picture = [" + pictures + "]\n[wheelset]\nleft.wheel = [\"S1002\", " + wheel +
         "]\nright.wheel = " + wheel +
         "\n[pose]\nyaw = [0.0, 0.01]\n"
         "lateral = [-1, 0, 1]\n[solve]\ngrid = [16, 16]\n[study]\nname = " +
         toml(file_name(text)) + "\ntitle = " + with_value + "\nresults = [" + results +
         "\"rolling_radius_difference\"]\nfields = [\"x\", \"y\", \"z\", \"pressure\"]\n";
}

TEST_F(HostileText, IsDrawnInAllPicturesOfStudies) {
  NEEDS_GNUPLOT();
  for (const std::string& text : some_of(hostile, 3)) {
    SCOPED_TRACE(text.substr(0, 100));
    clear();
    write_wheel(file_name(text) + ".txt");
    write("s.toml", study_of(text));
    const Outcome outcome =
        run(WRC_SWEEP_PROGRAM, "s.toml --quiet --out " + shell("./" + file_name(text)));
    EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
    expect_no_trace();
    constexpr std::size_t kinds = 6;
    expect_pictures(kinds);
    if (text == hostile.front()) { // and as it is
      for (const char* kind : {"map", "patches", "connections", "conicity", "ranking"}) {
        EXPECT_NE(read(text + '/' + text + kind + ".svg").find(">" + text + text + ".txt"),
                  std::string::npos)
            << kind;
      }
    }
  }
}

TEST_F(HostileText, IsDrawnInPicturesOfProfilesAndCases) {
  NEEDS_GNUPLOT();
  for (std::string text : some_of(hostile, 3)) {
    SCOPED_TRACE(text.substr(0, 100));
    clear();
    text = file_name(text) + '\xff'; // no UTF-8, which names need not be
    const std::string wheel = text + ".txt";
    write_wheel(wheel);
    const Outcome profile =
        run(WRC_PROFILE_PROGRAM, "./" + shell(wheel) + " --compare " + shell(wheel) + " --plot " +
                                     shell(text + "p.svg"));
    EXPECT_EQ(profile.exit_code, 0) << profile.error;
    const Outcome scene =
        run(WRC_CASE_PROGRAM,
            "--set " + shell("wheelset.wheel=./" + wheel + "; origin = tape") +
                " solve.results=stress 'solve.grid=[24,24]' 'creepage.left=[0.001,0,0]' "
                "--plot " +
                shell(text + "c.svg"));
    EXPECT_EQ(scene.exit_code, 0) << scene.error;
    EXPECT_FALSE(has_control_characters(profile.out)) << profile.out;
    EXPECT_FALSE(has_control_characters(scene.out)) << scene.out;
    expect_no_trace();
    expect_pictures(2);
  }
}

TEST_F(HostileText, IsNotSearchedForKeysOfTheStudy) {
  const std::string wheel = "{wheelset.wheel}{track.rail}.txt";
  write_wheel(wheel);
  write("s.toml",
        "[wheelset]\nwheel = " + toml(wheel) +
            "\n[track]\nrail = \"60E1\"\n[pose]\n"
            "lateral = [0, 1]\n[load]\nboth = 0\n[study]\ntitle = \"{wheelset.wheel}\"\n");
  ASSERT_EQ(run("timeout", "20 '" WRC_SWEEP_PROGRAM "' s.toml --page p.html").exit_code, 0);
  EXPECT_NE(read("p.html").find("\"title\":\"" + wheel + '"'), std::string::npos);
}

TEST_F(HostileText, IsPlainTextInThePage) {
  const std::vector<std::string> names{"evil/<img src=x onerror=alert(1)><!--\"'</script><script>"
                                       "alert(2)</scr.txt",
                                       "w1/=cmd|calc!A1.txt", "w1/x<script>alert(3)<b>.txt",
                                       "=1+1.txt", "\xe2\x80\xa8\xe2\x80\xa9.txt"};
  std::string list;
  for (const std::string& name : names) {
    list += (list.empty() ? "" : ", ") + toml(name);
  }
  write("s.toml", "[wheelset]\nwheel = [" + list +
                      "]\n[study]\ntitle = \"</script><script>alert("
                      "'t')</script> <!-- {pose.yaw} <script\"\n");
  const Outcome outcome = run(WRC_SWEEP_PROGRAM, "s.toml --page p.html");
  ASSERT_EQ(outcome.exit_code, 3) << outcome.error; // no scene has results
  const std::string page = read("p.html");
  const std::string begin = "const data = ";
  const std::size_t start = page.find(begin) + begin.size();
  const std::string data = page.substr(start, page.find(";\n", start) - start);
  for (const char* letters : {"<", "\xe2\x80\xa8", "\xe2\x80\xa9"}) {
    EXPECT_EQ(data.find(letters), std::string::npos) << letters;
  }
  const auto read = nlohmann::json::parse(data);
  EXPECT_EQ(read["axes"][0]["values"], nlohmann::json(names));
  EXPECT_EQ(read["title"], "</script><script>alert('t')</script> <!-- 0 <script");
  // Texts are set as such: page.html knows no other way.
  for (const char* way : {"innerHTML", "outerHTML", "insertAdjacentHTML", "document.write"}) {
    EXPECT_EQ(page.find(way), std::string::npos) << way;
  }
}

TEST_F(HostileText, IsOneStringOfAScript) {
  EXPECT_EQ(gnuplot_text("a `b` \"c\""), "'a `b` \"c\"'");
  EXPECT_EQ(gnuplot_text("it's ''"), "'it\u2019s \u2019\u2019'");
  EXPECT_EQ(gnuplot_text(std::string("a\nb\rc\0d\x1b\x7f\u0085\u2028", 14)), "'a b c d    '");
  EXPECT_EQ(gnuplot_text("\xff\xc3(\xed\xa0\x80\xf5\xc0\xafµ€😀"),
            "'\uFFFD\uFFFD(\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD\uFFFDµ€😀'");
  EXPECT_EQ(gnuplot_text("a_b^{c}@&~\\"), "'a\\_b\\^\\{c\\}\\@\\&\\~\\\\'");
  EXPECT_EQ(gnuplot_text("p_{max}, mm^2 a&b \\_", Markup::subscripts), "'p_{max}, mm^2 a\\&b \\_'");
  EXPECT_EQ(gnuplot_text("{/Symbol a}", Markup::subscripts), "'{\\/Symbol a}'");
  for (const char* open : {"a_{b", "a}_b{", "\\{a}"}) {
    EXPECT_EQ(gnuplot_text(open, Markup::subscripts), gnuplot_text(open));
  }
  EXPECT_EQ(gnuplot_text(driver::without_markup("a_{b"), Markup::subscripts), "'a\\_\\{b'");
  constexpr std::size_t long_text = 5000;
  EXPECT_EQ(gnuplot_text(std::string(long_text, 'x')), '\'' + std::string(400, 'x') + "\u2026'");
}

} // namespace
} // namespace hostile_text_test
