// Keys of stresses, wear and fatigue.
#include "keys/key_makers.hpp"
#include "keys/scene_key_table.hpp"

namespace wrc {
namespace {

using namespace dimensions;
using namespace key_makers;

/// Where a scene has what a word of solve.results requests.
template <class SceneType> auto requested_results(SceneType& scene) {
  return std::array{std::pair{std::string_view("stress"), &scene.damage.stress},
                    std::pair{std::string_view("wear"), &scene.damage.wear},
                    std::pair{std::string_view("fatigue"), &scene.damage.fatigue},
                    std::pair{std::string_view("groove"), &scene.damage.groove},
                    std::pair{std::string_view("kalker"), &scene.kalker}};
}

/// A set of words in any order, separated by blanks or commas.
Key results_key() {
  Key key;
  key.description = {"solve.results", "\"none\"",
                     "\"none\", or any of \"stress\", \"wear\", \"fatigue\", \"groove\" and "
                     "\"kalker\", as one text or a list of them",
                     "additional results: stresses below the surface; wear and fatigue, which need "
                     "creep forces; the groove that steel keeps where it yields; Kalker's "
                     "coefficients of each patch"};
  key.get = [](const Scene& scene) {
    std::string text;
    for (const auto& [word, flag] : requested_results(scene)) {
      if (*flag) {
        text.append(text.empty() ? "" : " ").append(word);
      }
    }
    return KeyValue(text.empty() ? "none" : text);
  };
  key.set_text = [](Scene& scene, std::string_view value) {
    const auto known = requested_results(scene);
    std::array<bool, known.size()> asked{};
    bool some = value == "none";
    while (!some && !value.empty()) {
      const std::size_t end = std::min(value.find_first_of(" ,"), value.size());
      const std::string_view word = value.substr(0, end);
      value.remove_prefix(std::min(end + 1, value.size()));
      const auto found = std::find_if(known.begin(), known.end(),
                                      [word](const auto& one) { return one.first == word; });
      if (found != known.end()) {
        asked[static_cast<std::size_t>(found - known.begin())] = true;
      } else if (!word.empty()) {
        return false;
      }
    }
    if (!some && std::find(asked.begin(), asked.end(), true) == asked.end()) {
      return false;
    }
    for (std::size_t i = 0; i < known.size(); ++i) {
      *known[i].second = asked[i];
    }
    return true;
  };
  return key;
}

/// Where a scene has something of the request.
template <class Value> auto damage_place(Value DamageRequest::*member) {
  return [member](auto& scene) -> auto& {
    return scene.damage.*member;
  };
}
template <class Value> auto law_place(Value WearRequest::*member) {
  return [member](auto& scene) -> auto& {
    return scene.damage.law.*member;
  };
}

} // namespace

std::vector<Key> make_damage_keys() {
  return {
      results_key(),
      word_key<bool>({"stress.body", "\"rail\"", "\"rail\" or \"wheel\"",
                      "body in which stresses are computed"},
                     {{"rail", false}, {"wheel", true}}, damage_place(&DamageRequest::of_wheel)),
      word_key<bool>(
          {"stress.section", "\"along\"", "\"along\" or \"across\"",
           "plane of the stress fields, through the point of the greatest von Mises stress"},
          {{"along", false}, {"across", true}}, damage_place(&DamageRequest::section_across)),
      word_key<WearLaw>(
          {"wear.law", "\"usfd\"", "\"usfd\", \"archard\" or \"energy\"",
           "wear law; usfd: by energy, for R8T wheel and 900A rail; archard: coefficients by "
           "sliding speed and pressure; energy: one coefficient"},
          {{"usfd", WearLaw::usfd}, {"archard", WearLaw::archard}, {"energy", WearLaw::energy}},
          law_place(&WearRequest::law)),
      number_key({"wear.energy_coefficient", "6.75e-7", "0 to 1 mm^3/(N mm)",
                  "worn volume per energy with law energy; the default is the mild rate of usfd"},
                 {0.0, 1.0}, Dimension{Quantity::area, false, "mm2/N"},
                 law_place(&WearRequest::energy_coefficient)),
      number_key({"wear.hardness", "3000.0", "1 to 1e9 MPa",
                  "hardness of the softer steel, with law archard"},
                 {1.0, 1e9}, stress, law_place(&WearRequest::hardness)),
      number_key(
          {"wear.scale", "1.0", "0 to 1e6", "factor on every law, for lubrication or other steels"},
          {0.0, 1e6}, pure, law_place(&WearRequest::scale)),
      optional_key({"fatigue.shear_yield", "\"auto\"", "\"auto\" or 1 to 1e9 MPa",
                    "yield stress in shear k of shakedown map and surface fatigue index; auto: "
                    "1/sqrt(3) of the yield stress of stress.body, or 300 MPa if it has none"},
                   {1.0, 1e9}, stress, &Scene::shear_yield, "auto")};
}

} // namespace wrc
