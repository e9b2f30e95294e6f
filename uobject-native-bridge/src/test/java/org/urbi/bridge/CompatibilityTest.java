package org.urbi.bridge;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.urbi.kernel.Kernel;

/** What components that were written for 2.7 take for granted. */
class CompatibilityTest {
  private static void prints(String output, List<String> expected) {
    for (String line : expected) {
      assertTrue(output.contains(line), () -> line + " is not in\n" + output);
    }
  }

  /** Names, macros and includes that nobody asks for. */
  @Test
  void oldNames() {
    Path file =
        CxxCompiler.libraryOf(
            "oldnames",
            """
            #include <libport/bind.hh>
            #include <libport/thread.hh>
            #include <urbi/customuvar.hh>
            GD_CATEGORY(Test.Old);
            ufloat half(ufloat n) { return n / 2; }
            struct Spot { ufloat x; std::vector<int> all; };
            URBI_REGISTER_STRUCT(Spot, x, all);
            class Old : public urbi::UObject
            {
            public:
              CREATE_CLASS_LOCK
              Old(const std::string& s) : urbi::UObject(s), port(this, "port", ctx_), stamps(0)
              {
                UBindFunctions(Old, timer, end, later, packed, spot, words);
                UBindThreadedFunction(Old, classLocked, urbi::LOCK_CLASS);
                urbi::createUCallback(*this, 0, "function", &half, __name + ".half");
                urbi::createUCallback(*this, 0, "function", this, &Old::slow, __name + ".slow")
                  ->setAsync(getTaskLock(urbi::LOCK_INSTANCE, "slow"));
                UBindVar(Old, told);
                UBindCacheVar(Old, cached, int);
                UNotifyThreadedChange(told, &Old::changed, urbi::LOCK_FUNCTION);
                UBindVar(Old, seen);
                aver(1 == 1);
                assert(urbi::getCurrentContext() == ctx_);
                urbi::UAutoValue five = 5;
                assert(five.type == urbi::DATA_DOUBLE && urbi::UAutoValue("a").type == urbi::DATA_STRING);
                assert(urbi::getFilteredHostname().find_first_of(".-") == std::string::npos);
              }
              std::string timer() { return *USetTimer(10, &Old::tick); }
              bool end(const std::string& t) { return removeTimer(urbi::TimerHandle(new std::string(t))); }
              void tick() { ++stamps; }
              void later()
              {
                libport::asyncCall(boost::bind(&Old::run, this, 8), 1000);
              }
              UPackedData<ufloat> packed(std::vector<ufloat> v) { return v; }
              Spot spot(Spot s) { s.x += 1; s.all.push_back(7); return s; }
              std::string words(std::list<std::string> all)
              {
                std::string out;
                foreach (const std::string& s, all)
                  out += s + ";";
                return libport::format("%s/%02d", out, all.size());
              }
              void run(int n)
              {
                ctx_->lock();
                seen = n;
                ctx_->unlock();
              }
              int classLocked() { return 5; }
              int slow() { return 6; }
              void changed(urbi::UVar& v) { seen = (int)v + cached.data(); }
              urbi::InputPort port;
              urbi::UVar told, seen;
              urbi::CustomUVar<int> cached;
              int stamps;
            };
            UStart(Old);
            """);
    String output =
        Dialogue.run(
            """
            var t = Old.timer| echo(t[0,6]);
            Old.end(t); Old.end(t); Old.end("nonsense");
            Old.half(3); Old.slow(); Old.classLocked();
            Old.words(["a", "b"]); Old.words("alone");
            Old.packed([1, 2]);
            Old.cached = 30|; Old.told = 12|; waituntil(!Old.seen.isVoid); Old.seen;
            Old.later|; waituntil(Old.seen == 8); echo("later");
            """,
            file);
    prints(
        output,
        List.of(
            "*** timer_",
            "] 1\n[00000000] 0\n[00000000] 0\n",
            "] 1.5",
            "] 6",
            "] 5",
            "\"a;b;/02\"",
            "\"alone;/01\"",
            "] BIN 16 ",
            "] 42",
            "*** later"));
  }

  /** A structure that can be made of a number is none for numbers. */
  @Test
  void structureWithConvertingConstructor() {
    Path file =
        CxxCompiler.libraryOf(
            "converting",
            """
            struct A { double x; A(double n = 0) : x(n) {} };
            URBI_REGISTER_STRUCT(A, x);
            struct B { std::vector<double> all; B(const std::vector<double>& a = std::vector<double>()) : all(a) {} };
            URBI_REGISTER_STRUCT(B, all);
            class Converting : public urbi::UObject
            {
            public:
              Converting(const std::string& s) : urbi::UObject(s)
              {
                UBindFunctions(Converting, number, structure, list, both);
                UBindVar(Converting, v);
                v = 1.5;
              }
              double number() { return 2.5; }
              double structure(A a) { return a.x; }
              std::vector<double> list() { return std::vector<double>(2, 1); }
              A both(B b) { return b.all.size(); }
              urbi::UVar v;
            };
            UStart(Converting);
            """);
    String output =
        Dialogue.run(
            """
            class A : UValueSerializable { var x = 0 }| var Serializables.A = A|
            Converting.number; Converting.v; Converting.list;
            Converting.structure(["x" => 4]);
            Converting.both(["all" => [1, 2, 3]]).x;
            """,
            file);
    prints(output, List.of("] 2.5", "] 1.5", "] [1, 1]", "] 4", "] 3"));
  }

  /** Whole numbers that a type cannot hold are told, and never become others. */
  @Test
  void numbersOutOfRange() {
    Path file =
        CxxCompiler.libraryOf(
            "ranges",
            """
            class Ranges : public urbi::UObject
            {
            public:
              Ranges(const std::string& s) : urbi::UObject(s)
              {
                UBindFunctions(Ranges, i, u, l, f, list);
                UBindVar(Ranges, v);
              }
              int i(int n) { return n; }
              unsigned u(unsigned n) { return n; }
              long long l(long long n) { return n; }
              float f(float n) { return n; }
              int list(std::vector<int> all) { return all.at(0); }
              urbi::UVar v;
            };
            UStart(Ranges);
            """);
    String output =
        Dialogue.run(
            """
            function told(f, x) { try { echo(f.apply([Ranges, x])) } catch (var e) { echo(e.message) } };
            told(Ranges.getSlotValue("i"), 1e12);
            told(Ranges.getSlotValue("i"), -2147483648);
            told(Ranges.getSlotValue("i"), 2.9);
            told(Ranges.getSlotValue("i"), nan);
            told(Ranges.getSlotValue("u"), -1);
            told(Ranges.getSlotValue("u"), 4294967295);
            told(Ranges.getSlotValue("l"), 1e19);
            told(Ranges.getSlotValue("l"), 9007199254740992);
            told(Ranges.getSlotValue("list"), [1e12]);
            """,
            file);
    prints(
        output,
        List.of(
            "i: invalid cast to int32 from 1e+12: out of range",
            "*** -2147483648",
            "*** 2\n",
            "i: invalid cast to int32 from nan: out of range",
            "u: invalid cast to unsigned int32 from -1: out of range",
            "*** 4294967295",
            "l: invalid cast to int64 from 1e+19: out of range",
            "*** 9007199254740992",
            "list: invalid cast to int32 from 1e+12: out of range"));
  }

  /** Where it is loaded is known while static variables are initialized. */
  @Test
  void modeInStaticInitializer() {
    Path file =
        CxxCompiler.libraryOf(
            "mode",
            """
            class Where : public urbi::UObject
            {
            public:
              Where(const std::string& s) : urbi::UObject(s) {}
            };
            ::urbi::URBIStarter<Where> starter(urbi::isPluginMode() ? "Here" : "There");
            """);
    try (Kernel kernel = Kernel.builder().log(line -> {}).start()) {
      kernel.eval("loadModule(\"" + file + "\")");
      assertEquals(true, kernel.eval("uobjects.hasLocalSlot(\"Here\")"));
    }
    assertEquals("There", NativeModule.load(file).module().classes().getFirst().name());
  }

  /** Nobody sees what a thread of a component's own is about to do while it holds the context. */
  @Test
  void lockedContext() {
    Path file =
        CxxCompiler.libraryOf(
            "locked",
            """
            #include <thread>
            class Locked : public urbi::UObject
            {
            public:
              Locked(const std::string& s) : urbi::UObject(s)
              {
                UBindFunctions(Locked, start, free);
                UBindVars(Locked, a, b, done);
                a = b = done = 0;
              }
              ~Locked() { if (thread.joinable()) thread.join(); }
              void start() { thread = std::thread([this] { run(); }); }
              int free() { return 7; }
              void run()
              {
                urbi::setCurrentContext(ctx_);
                ctx_->unlock(); // of no effect
                for (int n = 1; n <= 20; ++n)
                {
                  ctx_->lock();
                  ctx_->lock();
                  a = n;
                  ctx_->unlock();
                  usleep(2000);
                  b = n;
                  ctx_->unlock();
                  usleep(500);
                }
                done = 1;
              }
              urbi::UVar a, b, done;
              std::thread thread;
            };
            UStart(Locked);
            """);
    String output =
        Dialogue.run(
            """
            var torn = 0|; var looks = 0|;
            Locked.start;
            while (Locked.done == 0)
            {
              if (Locked.a != Locked.b) torn++;
              looks++;
              sleep(1ms)
            };
            torn; Locked.b; looks > 0; Locked.free;
            """,
            file);
    prints(output, List.of("] 0\n[", "] 20\n[", "] true\n[", "] 7\n"));
  }
}
