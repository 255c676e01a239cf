#include "report_page.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <string>

#include "apps/synthetic_plan.h"
#include "support/temporary_directory.h"
#include "text.h"

namespace dbd {
namespace {

using nlohmann::json;
using testing::HasSubstr;

int CountOf(const std::string& text, const std::string& part) {
  int count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++count;
  }
  return count;
}

class ReportPageTest : public testing::Test {
 protected:
  ReportPageTest() { WriteTextFile(image_, "not really a picture"); }

  std::string Page() const {
    const MapLayout layout{{{0, 100}, 0.5, 400, 200}, 76, 400, 346};
    return ReportPage(made_.record(), image_, layout);
  }

  /// What the page's script gets.
  static json DataOf(const std::string& page) {
    const std::string mark = "id=\"report-data\">";
    const std::size_t begin = page.find(mark) + mark.size();
    return json::parse(page.substr(begin, page.find("</script>", begin) - begin));
  }

  TemporaryDirectory scratch_;
  std::string image_ = scratch_.File("map.png");
  SyntheticPlan made_ = MakePlan(kUtm33);
};

TEST_F(ReportPageTest, NeedsNothingElse) {
  const std::string page = Page();
  for (const char* outside : {"src=\"", "href=\"", "@import", "<link", "fetch("}) {
    EXPECT_EQ(CountOf(page, outside), 0) << outside;
  }
  EXPECT_THAT(page, HasSubstr("Chart.js v"));
  // "not really a picture" in base 64.
  EXPECT_EQ(DataOf(page)["map"]["image"], "data:image/png;base64,bm90IHJlYWxseSBhIHBpY3R1cmU=");
}

// The route starts at x = 20, y = 50: 0.5 m pixels from the corner at 0, 100, below the title.
TEST_F(ReportPageTest, HasTheDriveInPixelsAndUnitsForPeople) {
  const json data = DataOf(Page());
  EXPECT_EQ(data["route"]["x"][0], 40);
  EXPECT_EQ(data["route"]["y"][0], 100 + 76);
  EXPECT_EQ(data["route"]["s"].size(), 161u);
  EXPECT_NEAR(data["route"]["columns"]["pitch_deg"][7].get<double>(), -5.712, 0.001);
  EXPECT_EQ(data["limits"].size(), 2u);
  EXPECT_EQ(data["limits"][1]["binding"], true);
  EXPECT_EQ(data["limits"][0]["margin"], 0.8);
}

TEST_F(ReportPageTest, ListsEveryCandidateWithItsReasonAndPlace) {
  made_.plan.rounds = {{"sample", 1, 1, 42.5}, {"polish", 1, 0, 42.5}};
  const json data = DataOf(Page());
  ASSERT_EQ(data["candidates"].size(), 2u);
  EXPECT_EQ(data["candidates"][0]["chosen"], true);
  EXPECT_EQ(data["candidates"][1]["round"], "2 polish");
  EXPECT_EQ(data["candidates"][1]["outcome"], "immobilized");
  EXPECT_EQ(data["candidates"][1]["reason"], "wheels spin");
  EXPECT_EQ(data["candidates"][1]["score"], nullptr);
  EXPECT_EQ(data["rounds"]["rows"][1], json::array({"polish", 1, 0, "42.5", "0.0"}));
}

TEST_F(ReportPageTest, TextFromFilesCannotBecomeMarkup) {
  made_.vehicle.name = "<b>&</b>";
  made_.plan.reason = "</script><script>alert(1)</script>";
  const std::string page = Page();
  EXPECT_EQ(CountOf(page, "alert(1)</script>"), 0);
  EXPECT_EQ(CountOf(page, "<b>"), CountOf(DataOf(page).dump(), "<b>"));
  EXPECT_EQ(DataOf(page)["reason"], made_.plan.reason);
}

TEST_F(ReportPageTest, WithoutARouteShowsTheCandidates) {
  made_ = MakeNoGoPlan(kUtm33);
  made_.plan.rounds = {{"sample", 2, 0}};
  const json data = DataOf(Page());
  EXPECT_EQ(data["route"], nullptr);
  EXPECT_TRUE(data["limits"].empty());
  EXPECT_EQ(data["candidates"].size(), 2u);
}

TEST_F(ReportPageTest, ShowsWhatTheDrawsSay) {
  made_.plan.rounds = {{"sample", 2, 1, 42.5}};
  SuccessEstimate estimate;
  estimate.draws = 10, estimate.reached = 8, estimate.low = 0.49, estimate.high = 0.943;
  estimate.mean_time = 33.04, estimate.cvar_time = 40;
  made_.plan.success = {estimate, std::nullopt};
  made_.options.uncertainty.draws = 10;
  const json data = DataOf(Page());
  EXPECT_EQ(data["extraColumns"].size(), 3u);
  EXPECT_EQ(data["candidates"][0]["extra"], json::array({"77 % (49–94)", "33.0", "40.0"}));
  EXPECT_TRUE(data["candidates"][1]["extra"].empty());
}

TEST_F(ReportPageTest, SaysWhatItRestsOn) {
  made_.arguments.terrain.dem = {image_};
  made_.arguments.vehicle = "tomcar-tm27";
  const json basis = DataOf(Page())["basis"];
  EXPECT_EQ(basis[0][0], "elevation");
  EXPECT_THAT(basis[0][1].get<std::string>(), HasSubstr("SHA-256 "));
  EXPECT_EQ(basis[1], json::array({"vehicle", "tomcar-tm27 (built in)"}));
}

}  // namespace
}  // namespace dbd
