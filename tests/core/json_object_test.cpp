#include <dbd/core/internal/json_object.h>

#include <gtest/gtest.h>

#include "support/core_vehicle.h"

namespace dbd {
namespace {

using internal::JsonObject;

JsonObject Read(const std::string& text) { return JsonObject::Parse(text, "f.json", "s/1"); }

// {"schema": "s/1", <body>}
JsonObject With(const std::string& body) { return Read("{\"schema\": \"s/1\", " + body + "}"); }

template <class Call>
std::string Message(const std::string& body, Call call) {
  return InputErrorOf([&] { call(With(body)); });
}

TEST(JsonObject, ReadsEveryKindOfValue) {
  const JsonObject o = With(
      R"("n": 2.5, "i": 3, "b": true, "t": "word", "v": [1, 2], "p": [1, 2, 3],
         "ps": [[1, 0, 0], [0, 1, 0]], "o": {"n": 7}, "os": [{"n": 8}, {"n": 9}])");
  EXPECT_EQ(o.Number("n", 0, 10), 2.5);
  EXPECT_EQ(o.Integer("i", 0, 10), 3);
  EXPECT_TRUE(o.Flag("b", false));
  EXPECT_EQ(o.Text("t"), "word");
  EXPECT_EQ(o.Numbers("v"), (std::vector<double>{1, 2}));
  EXPECT_EQ(o.Point("p"), Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(o.Points("ps", 2)[1], Eigen::Vector3d(0, 1, 0));
  EXPECT_EQ(o.Child("o").Number("n", 0, 10), 7);
  EXPECT_EQ(o.Children("os")[1].Number("n", 0, 10), 9);
  EXPECT_NO_THROW(o.RefuseUnknownKeys());
}

TEST(JsonObject, AbsentKeysTakeTheirDefaults) {
  const JsonObject o = With(R"("n": 1)");
  EXPECT_EQ(o.Number("m", 0, 10, 4), 4);
  EXPECT_FALSE(o.Flag("b", false));
  EXPECT_EQ(o.Text("t", "else"), "else");
  EXPECT_FALSE(o.Has("m"));
  EXPECT_TRUE(o.Has("n"));
}

TEST(JsonObject, NotesAreFreeForTheAuthor) {
  EXPECT_NO_THROW(With(R"("notes": ["why", "where from"])").RefuseUnknownKeys());
}

TEST(JsonObject, RefusesWhatIsNotAJsonObjectOfTheSchema) {
  EXPECT_EQ(InputErrorOf([] { Read("{ not json"); }), "f.json: is not valid JSON");
  EXPECT_EQ(InputErrorOf([] { Read(""); }), "f.json: is not valid JSON");
  EXPECT_EQ(InputErrorOf([] { Read("[1, 2]"); }), "f.json: must be a JSON object");
  EXPECT_EQ(InputErrorOf([] { Read("{}"); }), "f.json: schema: is missing");
  EXPECT_EQ(InputErrorOf([] { Read(R"({"schema": "s/2"})"); }),
            R"(f.json: schema: is "s/2", must be "s/1")");
  EXPECT_EQ(InputErrorOf([] { Read(R"({"schema": 1})"); }), "f.json: schema: is 1, must be text");
}

TEST(JsonObject, NumberMessagesNameFileKeyValueAndRule) {
  const auto number = [](const JsonObject& o) { o.Number("n", 0, 10); };
  EXPECT_EQ(Message(R"("m": 1)", number), "f.json: n: is missing");
  EXPECT_EQ(Message(R"("n": "5")", number), R"(f.json: n: is "5", must be a number)");
  EXPECT_EQ(Message(R"("n": -1)", number), "f.json: n: is -1, must be between 0 and 10");
  EXPECT_EQ(Message(R"("n": 10.5)", number), "f.json: n: is 10.5, must be between 0 and 10");
  EXPECT_EQ(Message(R"("n": null)", number), "f.json: n: is null, must be a number");
  EXPECT_EQ(Message(R"("n": 2.5)", [](const JsonObject& o) { o.Integer("n", 0, 10); }),
            "f.json: n: is 2.5, must be whole");
}

TEST(JsonObject, OtherKindsNameTheirRule) {
  EXPECT_EQ(Message(R"("b": 1)", [](const JsonObject& o) { o.Flag("b", true); }),
            "f.json: b: is 1, must be true or false");
  EXPECT_EQ(Message(R"("v": [1, "x"])", [](const JsonObject& o) { o.Numbers("v"); }),
            R"(f.json: v: is [1,"x"], must be a list of numbers)");
  EXPECT_EQ(Message(R"("v": [1, 2])", [](const JsonObject& o) { o.Numbers("v", 3); }),
            "f.json: v: is [1,2], must be a list of 3 numbers");
  EXPECT_EQ(Message(R"("ps": [[1, 2, 3]])", [](const JsonObject& o) { o.Points("ps", 2); }),
            "f.json: ps: must be a list of 2 points");
  EXPECT_EQ(Message(R"("o": 1)", [](const JsonObject& o) { o.Child("o"); }),
            "f.json: o: must be an object");
  EXPECT_EQ(Message(R"("os": [])", [](const JsonObject& o) { o.Children("os"); }),
            "f.json: os: must be a list of objects");
  EXPECT_EQ(Message(R"("os": [{}, 1])", [](const JsonObject& o) { o.Children("os"); }),
            "f.json: os[1]: must be an object");
}

TEST(JsonObject, MessagesCarryThePathThroughNestedObjects) {
  EXPECT_EQ(Message(R"("axles": [{}, {"tire": {"radius": -1}}])",
                    [](const JsonObject& o) {
                      o.Children("axles")[1].Child("tire").Number("radius", 0, 5);
                    }),
            "f.json: axles[1].tire.radius: is -1, must be between 0 and 5");
}

TEST(JsonObject, UnknownKeyNamesTheNearestOne) {
  const auto read = [](const JsonObject& o) {
    o.Has("stiffness"), o.Has("damping");
    o.RefuseUnknownKeys();
  };
  EXPECT_EQ(Message(R"("stifness": 1)", read),
            R"(f.json: stifness: is not a known key; did you mean "stiffness"?)");
}

TEST(JsonObject, LongValuesAreCutInMessages) {
  const std::string longer(500, 'x');
  const std::string message =
      Message("\"n\": \"" + longer + "\"", [](const JsonObject& o) { o.Number("n", 0, 1); });
  EXPECT_LT(message.size(), 120u);
  EXPECT_NE(message.find("..."), std::string::npos);
}

TEST(NearestWord, TakesTheFewestEdits) {
  EXPECT_EQ(internal::NearestWord("mas", {"mass", "inertia", "name"}), "mass");
  EXPECT_EQ(internal::NearestWord("intertia", {"mass", "inertia", "name"}), "inertia");
  EXPECT_EQ(internal::NearestWord("x", {}), "");
}

}  // namespace
}  // namespace dbd
