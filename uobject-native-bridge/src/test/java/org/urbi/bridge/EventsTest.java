package org.urbi.bridge;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

/** Events that call C++ code, and groups of its objects. */
class EventsTest {
  private static final String LISTENER =
      """
      class Listener : public urbi::UObject
      {
      public:
        Listener(const std::string& s) : urbi::UObject(s), count(0)
        {
          UAt(Listener, hit);
          UAt(Listener, ring);
          UAtEnd(Listener, press, released);
          UThreadedAt(Listener, later, urbi::LOCK_FUNCTION);
          UBindFunctions(Listener, said, quit);
          UAutoGroup();
          UJoinGroup("everybody");
        }
        void hit(int n, const std::string& who) { text += who + std::to_string(n) + " "; }
        void ring() { text += "ring "; }
        void press(double force) { text += force > 1 ? "hard " : "soft "; }
        void released() { text += "released "; }
        void later(int n) { text += "later" + std::to_string(n) + " "; }
        std::string said() const { return text; }
        void quit() { clean(); }
        std::string text;
        int count;
      };
      UStart(Listener);
      """;

  private static Path library;

  @BeforeAll
  static void compile() {
    library = CxxCompiler.libraryOf("listener", LISTENER);
  }

  private static List<String> answers(String program) {
    return Dialogue.run("sleep(1ms)|;" + program, library)
        .lines()
        .map(line -> line.replaceFirst("^\\[\\d+] ", ""))
        .toList();
  }

  @Test
  void emissionsWithAsManyArguments() {
    assertEquals(
        List.of("\"a1 ring \""),
        answers(
            """
            Listener.hit!(1, "a")| Listener.hit!(1)| Listener.hit!(1, 2, 3)|
            Listener.ring!()| sleep(1ms)|;
            Listener.said();
            """));
  }

  @Test
  void endsOfEmissions() {
    assertEquals(
        List.of("\"hard \"", "\"hard released \""),
        answers(
            """
            var e = Listener.press.trigger(2)|; sleep(1ms)|;
            Listener.said();
            e.stop()| sleep(1ms)|;
            Listener.said();
            """));
  }

  @Test
  void onThreads() {
    assertEquals(
        List.of("true"),
        answers(
            "Listener.later!(3)| while (Listener.said() == \"\") sleep(1ms)|;"
                + " Listener.said() == \"later3 \";"));
  }

  @Test
  void objectsThatHaveGoneAreNotCalled() {
    assertEquals(
        List.of("*** alive"),
        answers("var l = Listener|; l.quit()| l.ring!()| sleep(1ms)|; echo(\"alive\");"));
  }

  @Test
  void codeThatAConstructorSendsFindsTheObject() {
    for (int run = 0; run < 30; run++) {
      assertEquals(List.of("[Listener]"), answers("Listeners.asList;"));
    }
  }

  @Test
  void groups() {
    assertEquals(
        List.of("[[Listener], [Listener]]"), answers("[Listeners.asList, everybody.asList];"));
  }
}
