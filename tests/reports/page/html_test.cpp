// Is text that users wrote nothing but text in HTML and in scripts?
#include "reports/page/html.h"

#include <gtest/gtest.h>

#include "base/error.h"

namespace wedgesim::reports::page {
namespace {

TEST(Html, EscapesWhatMeansSomething) {
  EXPECT_EQ(escape("<a href=\"x\">'&'</a>"),
            "&lt;a href=&quot;x&quot;&gt;&#39;&amp;&#39;&lt;/a&gt;");
  EXPECT_EQ(element("td", "1 < 2"), "<td>1 &lt; 2</td>");
}

TEST(Html, ScriptsHoldNoTagAndStillTheSameValue) {
  const Json json{{"</script><!--", "<b>\"\\"}};
  const std::string text = script_json(json);
  EXPECT_EQ(text.find('<'), std::string::npos);
  EXPECT_EQ(Json::parse(text), json);
}

TEST(Html, TextThatIsNoUtf8IsReplacedNotRefused) {
  EXPECT_NO_THROW(script_json({{"name", "caf\xe9"}}));
}

TEST(Html, FillsInEachNameOnce) {
  EXPECT_EQ(fill("a {{x}} b {{y}}", {{"x", "{{y}}"}, {"y", "2"}}), "a {{y}} b 2");
  EXPECT_THROW(fill("{{x}}", {}), CheckError);
}

}  // namespace
}  // namespace wedgesim::reports::page
