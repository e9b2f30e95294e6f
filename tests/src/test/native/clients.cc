// A program that talks to a server, by all that the clients in C++ can do: clients PORT FILE, where FILE
// is its Unix domain socket, or by TLS: clients --tls HOST PORT. It says what is not as it should be, and ends with status 1 then.
#include <cstdio>
#include <cstring>
#include <string>

#include <urbi/usyncclient.hh>

using namespace urbi;

static std::atomic<int> failures(0);

#define CHECK(Condition)                                                                          \
  do                                                                                              \
    if (!(Condition))                                                                             \
    {                                                                                             \
      ++failures;                                                                                 \
      std::printf("%d: not so: %s\n", __LINE__, #Condition);                                      \
    }                                                                                             \
  while (false)

/// What has come, of which another thread waits for some.
class Inbox
{
public:
  UCallbackAction take(const UMessage& message)
  {
    std::lock_guard<std::mutex> guard(lock_);
    all_.push_back(message.tag + " " + message.rawMessage);
    come_.notify_all();
    return URBI_CONTINUE;
  }

  UCallbackAction takeOnce(const UMessage& message)
  {
    take(message);
    return URBI_REMOVE;
  }

  bool has(const std::string& text, size_t times = 1)
  {
    std::unique_lock<std::mutex> guard(lock_);
    return come_.wait_for(guard, std::chrono::seconds(20), [&] {
      size_t found = 0;
      for (const std::string& each : all_)
        found += each.find(text) != std::string::npos;
      return found >= times;
    });
  }

  size_t size()
  {
    std::lock_guard<std::mutex> guard(lock_);
    return all_.size();
  }

private:
  std::mutex lock_;
  std::condition_variable come_;
  std::list<std::string> all_;
};

static void callbacks(unsigned port)
{
  Inbox tagged, errors, everything, once, answers;
  UClient client("localhost", port);
  CHECK(client.error() == 0 && client.init() && client.getServerPort() == port);
  client.setCallback(tagged, &Inbox::take, "mine");
  client.setCallback(once, &Inbox::takeOnce, "mine");
  client.setErrorCallback(callback(errors, &Inbox::take));
  client.setWildcardCallback(callback(everything, &Inbox::take));
  client.send("var mine = Channel.new(\"mine\")|; mine << %d; mine << \"a\\\"b\";", 6 * 7);
  CHECK(tagged.has("mine 42") && tagged.has("mine \"a\\\"b\""));
  CHECK(once.has("mine 42"));
  client << "mine << [1, " << 2.5 << "];" << std::endl;
  CHECK(tagged.has("[1, 2.5]"));
  CHECK(once.size() == 1);
  client.send(std::string("nonsense;"));
  CHECK(errors.has("lookup failed: nonsense"));
  client.send("var Global.b = ");
  client.sendBinary("a;b\nc", 5, "jpeg 3 4");
  client.send(";");
  CHECK(everything.has("BIN 5 jpeg 3 4"));
  UCallbackID id = client.sendCommand(callback(answers, &Inbox::take), "1 + 1;");
  CHECK(answers.has(" 2"));
  CHECK(client.deleteCallback(id) == 1 && client.deleteCallback(id) == 0);
}

static void questions(unsigned port)
{
  Inbox inbox;
  USyncClient client("127.0.0.1", port);
  ufloat number = 0;
  CHECK(client.syncGetResult("1 + 2 * 3", number) == 1 && number == 7);
  UValue value;
  CHECK(client.syncGetValue("[1, \"two\", [\"three\" => 3]]", value) == 1);
  CHECK(value.type == DATA_LIST && value.list->size() == 3);
  CHECK(static_cast<std::string>((*value.list)[1]) == "two");
  UMessage* message = client.syncGet("\"%s\"", "formatted");
  CHECK(message && message->value && static_cast<std::string>(*message->value) == "formatted");
  delete message;
  message = client.syncGet(std::string("nonsense"));
  CHECK(message && message->type == MESSAGE_ERROR && !message->value
        && message->message.find("lookup failed: nonsense") != std::string::npos);
  delete message;
  CHECK(client.syncGetResult("\"no number\"", number) == 0);
  CHECK(client.syncGetResult("nonsense", number) == 0);
  // What takes too long is not waited for.
  CHECK(!client.syncGet(100000, "{ sleep(10s); %d }", 1));
  client.send("class Global.motor { var val = 12; var P = 3; };");
  CHECK(client.syncGetDevice("motor", number) == 1 && number == 12);
  CHECK(client.syncGetDevice("motor", "P", number) == 1 && number == 3);
  client.send("var Global.cam = Object.clone()|; var cam.val = BIN 6 rgb 2 1;abcdef;");
  char buffer[16];
  size_t size = sizeof buffer, width = 0, height = 0;
  CHECK(client.syncGetImage("cam", buffer, size, width, height) == 1 && size == 6 && width == 2
        && height == 1 && std::memcmp(buffer, "abcdef", 6) == 0);
  // In a callback, too.
  client.setCallback(
    [&](const UMessage&) {
      ufloat three = 0;
      CHECK(client.isCallbackThread());
      CHECK(client.syncGetResult("1 + 2", three) == 1 && three == 3);
      return URBI_CONTINUE;
    },
    "ask");
  client.setCallback(inbox, &Inbox::take, "ask");
  client.send("Channel.new(\"ask\") << 1;");
  CHECK(inbox.has("ask 1"));
  std::thread later([&] { client.send("Channel.new(\"awaited\") << 5;"); });
  message = client.waitForTag("awaited", 20000000);
  CHECK(message && message->value && static_cast<int>(*message->value) == 5);
  delete message;
  later.join();
}

/// What is told how to ask, and to call.
static void settings(unsigned port)
{
  USyncClient client("127.0.0.1", port);
  CHECK(client.connectionID().find("Lobby_") == 0);
  CHECK(getClientConnectionID(&client) == client.connectionID());
  UMessage* message = client.syncGetTag("%d * 2", "named", nullptr, 21);
  CHECK(message && message->tag == "named" && static_cast<int>(*message->value) == 42);
  delete message;
  client.setDefaultOptions(USyncClient::send_options().timeout(100000).tag("hasty"));
  CHECK(client.getOptions().timeout_ == 100000);
  CHECK(!client.syncGet(std::string("{ sleep(10s); 1 }")));
  client.setDefaultOptions(USyncClient::send_options());
  // What comes before somebody waits for it is kept for him.
  Inbox inbox;
  client.setCallback(inbox, &Inbox::take, "kept");
  client.lockQueue();
  client.send("Channel.new(\"kept\") << 7;");
  message = client.syncGet("1");
  delete message;
  message = client.waitForTag("kept", 20000000);
  CHECK(message && static_cast<int>(*message->value) == 7 && inbox.size() == 0);
  delete message;
  std::atomic<bool> other(false);
  client.setSynchronous(true);
  client.setCallback(
    [&](const UMessage&) {
      other = !client.isCallbackThread();
      return URBI_CONTINUE;
    },
    "kept");
  client.send("Channel.new(\"kept\") << 8;");
  CHECK(inbox.has("kept 8"));
  delete client.syncGet("1");
  CHECK(other);
}

static void withoutThread(unsigned port)
{
  Inbox inbox;
  USyncClient client("127.0.0.1", port, UAbstractClient::URBI_BUFLEN, false);
  client.setCallback(inbox, &Inbox::take, "mine");
  client.send("Channel.new(\"mine\") << 1;");
  ufloat one = 0;
  CHECK(client.syncGetResult("1", one) == 1);
  CHECK(inbox.size() == 0);
  CHECK(client.processEvents(20000000) && inbox.size() == 1);
}

static void what_goes_wrong(unsigned port)
{
  UClient nobody("127.0.0.1", 1);
  CHECK(nobody.error() != 0 && nobody.send("1;") != 0);
  Inbox inbox;
  USyncClient client("127.0.0.1", port);
  client.setClientErrorCallback(callback(inbox, &Inbox::take));
  client.send("quit;");
  CHECK(inbox.has("End of file"));
  CHECK(!client.syncGet("1"));
}

static void byFile(const std::string& file)
{
  USyncClient client(file, 1);
  ufloat answer = 0;
  CHECK(client.error() == 0 && client.syncGetResult("6*7", answer) == 1 && answer == 42);
  std::string text(300000, 'x');
  UMessage* message = client.syncGet("\"" + text + "\"");
  CHECK(message && message->value && std::string(*message->value) == text);
  delete message;
  UClient nobody("/nowhere/at/all", 1);
  CHECK(nobody.error() != 0);
  UClient tooLong("/" + std::string(200, 'x'), 1);
  CHECK(tooLong.error() != 0);
}

/// Waits until an expression is true in a server.
static bool becomes_true(USyncClient& judge, const std::string& expression)
{
  std::string answer;
  for (int i = 0; i < 500 && answer != "true"; ++i)
  {
    UMessage* message = judge.syncGet("(" + expression + ").asString");
    if (message && message->value && message->value->type == DATA_STRING)
      answer = std::string(*message->value);
    delete message;
    usleep(20000);
  }
  return answer == "true";
}

/// By TLS, says the environment: why there is no connection, or what is not as it should be.
static int secure(const std::string& host, unsigned port)
{
  USyncClient client(host, port);
  if (client.error())
  {
    std::printf("%s\n", client.errorMessage().c_str());
    return 0;
  }
  std::string text(300000, 'x');
  UMessage* message = client.syncGet("\"" + text + "\"");
  CHECK(message && message->value && std::string(*message->value) == text);
  delete message;
  client.send("var Global.sum = 0|;");
  std::thread other([&client] {
    for (int i = 0; i < 300; ++i)
      client.send("Global.sum += 1|;");
  });
  for (int i = 0; i < 300; ++i)
    client.send("Global.sum += 1|;");
  other.join();
  CHECK(becomes_true(client, "Global.sum == 600"));
  client.send("Global.removeLocalSlot(\"sum\")|;");
  CHECK(becomes_true(client, "!Global.hasSlot(\"sum\")"));
  std::printf("%d failures\n", failures.load());
  return failures != 0;
}

int main(int argc, char* argv[])
{
  std::setvbuf(stdout, nullptr, _IONBF, 0);
  if (argc == 4)
    return secure(argv[2], static_cast<unsigned>(std::atoi(argv[3])));
  unsigned port = argc == 3 ? static_cast<unsigned>(std::atoi(argv[1])) : 0;
  callbacks(port);
  questions(port);
  settings(port);
  withoutThread(port);
  what_goes_wrong(port);
  byFile(argc == 3 ? argv[2] : "");
  std::printf("%d failures\n", failures.load());
  return failures != 0;
}
