// Tests of the headers by themselves: run plain, with AddressSanitizer, and by Valgrind. The host is
// one of C++, which keeps variables in memory.
#include <cstdio>
#include <deque>
#include <memory>
#include <set>
#include <unordered_map>

#include <urbi/uobject.hh>
#include <urbi/usyncclient.hh>

// What a module is called by; where its code was compiled separately, it is seen by nobody else.
#include <urbi/detail/entry.hh>

static int failures = 0;

#define CHECK(Condition)                                                                          \
  do                                                                                              \
    if (!(Condition))                                                                             \
    {                                                                                             \
      ++failures;                                                                                 \
      std::printf("%s:%d: not so: %s\n", __FILE__, __LINE__, #Condition);                         \
    }                                                                                             \
  while (false)

#define CHECK_THROWS(Statement, Text)                                                             \
  do                                                                                              \
  {                                                                                               \
    std::string thrown = "nothing";                                                               \
    try                                                                                           \
    {                                                                                             \
      Statement;                                                                                  \
    }                                                                                             \
    catch (const std::exception& e)                                                               \
    {                                                                                             \
      thrown = e.what();                                                                          \
    }                                                                                             \
    if (thrown != (Text))                                                                         \
    {                                                                                             \
      ++failures;                                                                                 \
      std::printf("%s:%d: %s threw %s\n", __FILE__, __LINE__, #Statement, thrown.c_str());        \
    }                                                                                             \
  } while (false)

struct Point
{
  double x = 0, y = 0;
};
URBI_REGISTER_STRUCT(Point, x, y);

enum Colour
{
  RED,
  GREEN,
};

using namespace urbi;

static UValue parsed(const std::string& text)
{
  UValue value;
  if (!detail::read_literal(text, value))
    value = "no literal";
  return value;
}

static std::string shown(const UValue& value)
{
  return detail::literal_of(value);
}

template <typename T>
static T there_and_back(const T& object)
{
  UValue value;
  value = object;
  uint8_t small[8], other[8];
  detail::Writer out(small, sizeof small, true);
  out.value(value);
  detail::Reader in(out.data(), out.size());
  UValue read;
  in.value(read);
  CHECK(in.ended());
  CHECK(shown(read) == shown(value));
  detail::Writer pointing(other, sizeof other, false);
  pointing.value(value);
  detail::Reader again(pointing.data(), pointing.size());
  again.value(read);
  CHECK(shown(read) == shown(value));
  return uvalue_cast<T>(read);
}

static void literals()
{
  for (const char* same :
       {"1", "-2.5", "1e+100", "\"a\\\"b\\n\\x01\"", "[1, [\"x\"], []]", "[\"a\" => 1, \"b\" => [2]]",
        "[ => ]", "camera.val", "inf", "BIN 3 jpeg 4 5;abc", "[BIN 0;, 2]"})
    CHECK(shown(parsed(same)) == same);
  CHECK(shown(parsed("1h2min3s")) == "3723");
  CHECK(shown(parsed("-100ms")) == "-0.1");
  CHECK(shown(parsed("0x1F")) == "31");
  CHECK(shown(parsed("'a' \"b\"")) == "\"ab\"" || shown(parsed("\"a\" \"b\"")) == "\"ab\"");
  CHECK(shown(parsed("BIN 3 jpeg 4 5\nabc")) == "BIN 3 jpeg 4 5;abc");
  CHECK(parsed("true").val == 1);
  CHECK(parsed("void").type == DATA_VOID);
  for (const char* none : {"", "[1", "\"a", "BIN 10;abc", "1 2", "[1 => 2]", "-"})
    CHECK(shown(parsed(none)) == "\"no literal\"");
  CHECK(shown(parsed(std::string(5000, '['))) == "\"no literal\"");
}

static void casts()
{
  CHECK(there_and_back(1.5) == 1.5);
  CHECK(there_and_back(std::string("text")) == "text");
  CHECK(there_and_back(true));
  CHECK(there_and_back(GREEN) == GREEN);
  CHECK((there_and_back(std::vector<int>{1, 2}) == std::vector<int>{1, 2}));
  CHECK((there_and_back(std::list<std::string>{"a"}) == std::list<std::string>{"a"}));
  CHECK((there_and_back(std::deque<bool>{true, false}) == std::deque<bool>{true, false}));
  CHECK((there_and_back(std::set<int>{2, 1}) == std::set<int>{1, 2}));
  CHECK((there_and_back(std::array<int, 2>{{3, 4}}) == std::array<int, 2>{{3, 4}}));
  CHECK((there_and_back(std::map<std::string, double>{{"a", 1}}).at("a") == 1));
  CHECK((there_and_back(std::unordered_map<std::string, std::vector<int>>{{"a", {1}}}).size() == 1));
  CHECK((there_and_back(std::make_pair(1, std::string("b"))).second == "b"));
  CHECK(!there_and_back(std::optional<int>()));
  CHECK((there_and_back(UPackedData<float>(std::vector<float>{1, 2}))[1] == 2));
  std::vector<Point> points(3);
  points[1].y = 7;
  CHECK(there_and_back(points)[1].y == 7);
  CHECK(static_cast<int>(UValue("12")) == 12);
  CHECK(static_cast<std::string>(UValue(12)) == "12");
  UValue huge(1e300), negative(-1);
  CHECK_THROWS(uvalue_cast<int>(huge), "invalid cast to int32 from 1e+300: out of range");
  CHECK_THROWS(uvalue_cast<unsigned>(negative), "invalid cast to unsigned int32 from -1: out of range");
  CHECK(uvalue_cast<int>(negative) == -1);
  UValue text("twelve"), number(1), list = parsed("[1]"), nothing;
  CHECK_THROWS(uvalue_cast<int>(text), "invalid cast to double from \"twelve\"");
  CHECK_THROWS(uvalue_cast<UList>(number), "invalid cast to UList from 1");
  CHECK_THROWS(uvalue_cast<Point>(list), "invalid cast to Point from [1]");
  CHECK_THROWS(uvalue_cast<UImage>(nothing), "invalid cast to UImage from void");
  UValue half = parsed("[\"x\" => 1]");
  CHECK_THROWS(uvalue_cast<Point>(half), "a Point is missing field y");
  // A value may become a part of itself.
  UValue nested = parsed("[[1], 2]");
  nested = (*nested.list)[0];
  CHECK(shown(nested) == "[1]");
}

static void binaries()
{
  UBinary binary;
  binary.set("rgb 2 1", const_cast<char*>("abcdef"), 6);
  CHECK(binary.type == BINARY_IMAGE && binary.image.width == 2 && binary.image.height == 1);
  UBinary copy(binary), shared(binary, false);
  CHECK(copy.common.data != binary.common.data && shared.common.data == binary.common.data);
  copy = shared;
  CHECK(shown(UValue(copy)) == "BIN 6 rgb 2 1;abcdef");
  copy = std::move(shared);
  UBinary temporary(binary, true, true);
  UBinary thief(temporary);
  CHECK(thief.common.size == 6 && temporary.common.size == 0);
  binary.set("raw 2 8000 16 1", nullptr, 0);
  CHECK(binary.type == BINARY_SOUND && binary.sound.rate == 8000);
  CHECK(binary.getMessage() == "raw 2 8000 16 1");
  binary.set("something else", const_cast<char*>("x"), 1);
  CHECK(binary.type == BINARY_UNKNOWN && binary.getMessage() == "something else");
  std::set<const void*> images;
  UList list;
  for (int i = 0; i < 3; ++i)
    list.push_back(thief);
  for (UValue* each : list)
    images.insert(each->binary->common.data);
  CHECK(images.size() == 3);
}

static void messages()
{
  std::vector<std::string> got;
  detail::MessageSplitter splitter;
  std::string stream = "[00000001:t] BIN 4 jpeg\n\n\n\n\n\r\n[2] \"BIN 9\"\n[3] *** BIN 5 a\n[4:e] !!! b";
  // In pieces of any size.
  for (size_t piece = 1; piece < stream.size(); ++piece)
  {
    got.clear();
    detail::MessageSplitter each;
    std::string all = stream + "\n";
    for (size_t at = 0; at < all.size(); at += piece)
      each.feed(all.data() + at, std::min(piece, all.size() - at),
                [&](int time, const std::string& tag, const std::string& text) {
                  got.push_back(std::to_string(time) + tag + " " + text);
                });
    CHECK(got.size() == 4 && got[0] == "1t BIN 4 jpeg\n\n\n\n\n" && got[3] == "4e !!! b");
  }
}

// ------------------------------------------------------------------ a host

static std::map<std::string, UValue> variables;
static std::vector<std::string> slots(1);
static std::map<std::string, int64_t> functions;
static std::vector<std::string> log_lines;

static int64_t host(urbi_exchange* exchange)
{
  detail::Reader in(exchange->data, exchange->length);
  detail::Writer out(exchange->reply, exchange->reply_capacity, true);
  int64_t result = 0;
  switch (exchange->operation)
  {
  case URBI_MODE: result = 1; break;
  case URBI_FUNCTION:
  {
    std::string name = in.text();
    functions[name] = in.raw<int64_t>();
    break;
  }
  case URBI_VARIABLE:
    slots.push_back(in.text());
    result = static_cast<int64_t>(slots.size() - 1);
    if (slots.back().compare(0, 7, "nowhere") == 0)
    {
      const std::string text = "UVar creation on non existing object: nowhere";
      out.bytes(text.data(), text.size());
      result = URBI_FAILED;
    }
    break;
  case URBI_VARIABLE_GET: out.value(variables[slots[exchange->subject]]); break;
  case URBI_VARIABLE_SET: in.value(variables[slots[exchange->subject]]); break;
  case URBI_SEND: log_lines.push_back(in.text()); break;
  case URBI_OBJECT_GONE: log_lines.push_back("gone"); break;
  default: break;
  }
  exchange->reply_length = out.size();
  exchange->reply = out.release();
  return result;
}

static std::string call(const std::string& function, const std::string& arguments)
{
  uint8_t data[16], reply[16];
  detail::Writer in(data, sizeof data, true);
  UValue list = parsed(arguments);
  for (UValue* each : *list.list)
    in.value(*each);
  urbi_exchange exchange = {0, 1, functions.at(function), in.data(), in.size(), reply, 16, 0};
  int64_t status = urbi_module_invoke(&exchange);
  std::string text;
  if (status == URBI_FAILED)
    text = "!" + std::string(reinterpret_cast<char*>(exchange.reply),
                             static_cast<size_t>(exchange.reply_length));
  else
  {
    UValue result;
    detail::Reader(exchange.reply, exchange.reply_length).value(result);
    text = shown(result);
  }
  if (exchange.reply != reply)
    urbi_module_free(exchange.reply);
  return text;
}

class Tested : public UObject
{
public:
  Tested(const std::string& s)
    : UObject(s)
  {
    UBindVars(Tested, v, w);
    UBindFunctions(Tested, add, join, point, image, fail, none, sendIt, grow);
    v = 2;
  }

  double add(int a, const float& b) const
  {
    return a + b + v;
  }

  std::string join(const std::vector<std::string>& all, const char* separator)
  {
    std::string whole;
    for (const std::string& each : all)
      whole += (whole.empty() ? "" : separator) + each;
    return whole;
  }

  Point point(Point p)
  {
    std::swap(p.x, p.y);
    w = p;
    return w.as<Point>();
  }

  UImage image(UBinary& binary)
  {
    return static_cast<UImage>(binary.image);
  }

  void fail()
  {
    throw std::runtime_error("failed");
  }

  void none()
  {
    UVar("nowhere", "x");
  }

  void sendIt()
  {
    URBI((f(1, "a"), g()));
    URBI(()) << "h(" << 2 << ");";
  }

  std::string grow(size_t size)
  {
    return std::string(size, 'x');
  }

  UVar v;
  UVar w;
};
UStart(Tested);

static void objects()
{
  uint8_t data[64], reply[64];
  urbi_exchange exchange = {0, 0, 0, nullptr, 0, reply, 64, 0};
  CHECK(urbi_module_open(host, &exchange) == 0);
  detail::Reader declared(exchange.reply, exchange.reply_length);
  CHECK(declared.text() == "class" && declared.text() == "Tested" && declared.ended());

  detail::Writer in(data, sizeof data, true);
  in.text("Tested");
  in.text("Tested");
  exchange = {0, 1, 5, in.data(), in.size(), reply, 64, 0};
  int64_t object = urbi_module_create(&exchange);
  CHECK(object != URBI_FAILED);

  CHECK(call("add", "[1, 0.5]") == "3.5");
  CHECK(call("join", "[[\"a\", 2], \"-\"]") == "\"a-2\"");
  CHECK(call("point", "[[\"x\" => 1, \"y\" => 2]]") == "[\"$sn\" => \"Point\", \"x\" => 2, \"y\" => 1]");
  CHECK(call("image", "[BIN 3 rgb 1 1;abc]") == "BIN 3 rgb 1 1;abc");
  CHECK(call("fail", "[]") == "!failed");
  CHECK(call("none", "[]") == "!UVar creation on non existing object: nowhere");
  CHECK(call("add", "[\"x\", 1]") == "!invalid cast to double from \"x\"" + std::string()
        || call("add", "[\"x\", 1]").compare(0, 13, "!invalid cast") == 0);
  CHECK(call("grow", "[1000]").size() == 1002);
  call("sendIt", "[]");
  CHECK(log_lines.size() == 2 && log_lines[1] == "h(2);");

  exchange = {0, 1, object, nullptr, 0, reply, 64, 0};
  CHECK(urbi_module_destroy(&exchange) == 0);
}

int main()
{
  literals();
  casts();
  binaries();
  messages();
  objects();
  std::printf("%d failures\n", failures);
  return failures != 0;
}
