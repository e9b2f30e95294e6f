package org.urbi.kernel;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

/** The names that are offered to somebody who types. */
class CompletionTest {
  private static Kernel kernel;
  private static Connection connection;

  @BeforeAll
  static void connect() throws InterruptedException {
    CountDownLatch told = new CountDownLatch(1);
    kernel = Kernel.builder().virtualTime(true).start();
    connection =
        connect(output -> {
          if (output.contains("ready")) {
            told.countDown();
          }
        });
    connection.send(
        """
        class Robot { var head = Object.new; var heading = 0; function help() { throw "called" } }|;
        var robot = Robot.new|;
        var robot.head.camera = 1|;
        var rocket = 2|;
        var crew = [robot, "Ann"]|;
        class Probe { get trap() { throw "called" }; get trance() { sleep(inf) } }|;
        var probe = Probe.new|;
        var crowd = Object.new|;
        for| (var i : 20000) crowd.setSlot("slot_" + i, i);
        echo("ready");
        """);
    told.await();
  }

  private static Connection connect(Consumer<String> output) {
    return kernel.connect(
        new Client() {
          @Override
          public void output(String bytes) {
            output.accept(bytes);
          }

          @Override
          public void closed() {}
        });
  }

  @AfterAll
  static void close() {
    kernel.close();
  }

  private static List<String> complete(String text) {
    return connection.complete(text).join();
  }

  @Test
  void slotsOfTheLobbyAreOffered() {
    assertEquals(List.of("robot", "rocket", "round"), complete("echo(ro"));
    assertEquals(List.of("rocket"), complete("robot.heading + roc"));
  }

  @Test
  void keywordsAreOfferedWhereAnExpressionBegins() {
    assertEquals(List.of("whenever"), complete("{ whenev"));
    assertEquals(List.of(), complete("robot.whenev"));
  }

  @Test
  void slotsOfAnObjectAndItsPrototypesAreOffered() {
    assertEquals(List.of("head", "heading", "help"), complete("robot.he"));
    assertEquals(List.of("camera"), complete("if (this.robot.head.cam"));
    assertTrue(complete("robot.").contains("asString"));
  }

  @Test
  void nothingIsCalled() {
    assertEquals(List.of(), complete("robot.help.he"));
    assertEquals(List.of(), complete("f().he"));
    assertEquals(List.of("trance", "trap"), complete("probe.tra"));
    assertEquals(List.of(), complete("probe.trap.he"));
    assertEquals(List.of(), complete("probe.trance.he"));
    assertEquals(List.of(), complete("missing.he"));
  }

  @Test
  void slotsOfWhatAnExpressionGivesAreOffered() {
    assertEquals(List.of("toLower"), complete("\"a \\\" . b\".toL"));
    assertEquals(List.of("sqr", "sqrt"), complete("echo((1 + 2.5).sq"));
    assertEquals(List.of("sqr", "sqrt"), complete("2s.sq"));
    assertEquals(List.of("reverse"), complete("[1, [2]].rev"));
    assertEquals(List.of("keys"), complete("[\"a\" => 1].key"));
    assertEquals(List.of("head", "heading", "help"), complete("crew[0].he"));
    assertEquals(List.of("toLower"), complete("crew[1].toL"));
    assertEquals(List.of("head", "heading", "help"), complete("Robot.new.he"));
    // The library declares what these give.
    assertEquals(List.of("sqr", "sqrt"), complete("crew.size.sq"));
    assertEquals(List.of("toLower"), complete("[1, 2].join(\", \").toL"));
  }

  @Test
  void localNamesAreOffered() {
    assertEquals(List.of("rosette"), complete("function f(rosette, b = 2) { rose"));
    assertEquals(List.of("rosette"), complete("{ var rosette = 1; rose"));
    assertEquals(List.of("rosette"), complete("for (var rosette : crew) { echo(rose"));
    assertEquals(List.of("head", "heading", "help"), complete("{ var r = Robot.new; r.he"));
    assertEquals(List.of("toLower"), complete("{ var r = crew | var s = r[1]; s.toL"));
    // They are not seen outside of their braces.
    assertEquals(List.of(), complete("{ var rosette = 1 } | rose"));
    assertEquals(List.of(), complete("function f(rosette) { rosette } | rose"));
    // One that is declared with itself ends.
    assertEquals(List.of(), complete("{ var r = r; r.he"));
  }

  @Test
  void nothingIsOfferedWithinStringsAndComments() {
    assertEquals(List.of(), complete("echo(\"ro"));
    assertEquals(List.of(), complete("/* ro"));
    assertEquals(List.of(), complete("1; // ro"));
    assertEquals(List.of("robot", "rocket", "round"), complete("/* \" */ // x\n ro"));
  }

  @Test
  void ofVeryManySlotsTheFirstAreOffered() {
    List<String> found = complete("crowd.slot_");
    assertEquals(500, found.size());
    assertEquals(List.of("slot_0", "slot_1", "slot_10"), found.subList(0, 3));
  }

  @Test
  void whateverIsTypedIsAnswered() {
    for (String odd :
        List.of(".", "..", ").x", "].x", "}.x", "1..x", "\0.\1", "é.", "BIN 10 x;.a", "'")) {
      assertEquals(List.of(), complete(odd), odd);
    }
    complete("(".repeat(100_000) + "a");
    complete("{ var a = ".repeat(5_000) + "a.");
    complete("f(".repeat(5_000) + "1" + ")".repeat(5_000) + ".a");
  }

  @Test
  void operatorsAndEverythingAtOnceAreNot() {
    assertFalse(complete("1 + robot.").contains("+"));
    assertEquals(List.of(), complete(""));
    assertEquals(List.of(), complete("robot.head "));
  }

  @Test
  void aClosedLobbyHasNone() {
    Connection closed = connect(output -> {});
    closed.close();
    assertEquals(List.of(), closed.complete("ro").join());
  }

  /** It would take long to parse it, and somebody could ask again and again. */
  @Test
  void whatNobodyTypesIsNotParsed() {
    assertEquals(
        List.of("heading"), complete("(".repeat(400) + "robot" + ")".repeat(400) + ".headi"));
    assertEquals(List.of(), complete("(".repeat(600) + "robot" + ")".repeat(600) + ".headi"));
  }

  /** While the kernel is held, somebody asks and asks. */
  @Test
  void questionsThatOutrunTheAnswersAreAnsweredAtOnce() throws InterruptedException {
    KernelHold hold = new KernelHold(kernel);
    hold.begin(connection);
    List<CompletableFuture<List<String>>> asked =
        IntStream.range(0, 100).mapToObj(i -> connection.complete("robot.headi")).toList();
    try {
      assertEquals(84, asked.stream().filter(CompletableFuture::isDone).count());
    } finally {
      hold.end();
    }
    assertEquals(List.of("heading"), asked.getFirst().join());
    assertEquals(List.of("heading"), complete("robot.headi"));
  }
}
