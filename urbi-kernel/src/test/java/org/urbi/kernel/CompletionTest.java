package org.urbi.kernel;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.concurrent.CountDownLatch;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** The names that are offered to somebody who types. */
class CompletionTest {
  private final CountDownLatch told = new CountDownLatch(1);
  private Kernel kernel;
  private Connection connection;

  @BeforeEach
  void connect() throws InterruptedException {
    kernel = Kernel.builder().virtualTime(true).start();
    connection =
        kernel.connect(
            new Client() {
              @Override
              public void output(String bytes) {
                if (bytes.contains("ready")) {
                  told.countDown();
                }
              }

              @Override
              public void closed() {}
            });
    connection.send(
        """
        class Robot { var head = Object.new; var heading = 0; function help() { throw "called" } }|;
        var robot = Robot.new|;
        var robot.head.camera = 1|;
        var rocket = 2|;
        echo("ready");
        """);
    told.await();
  }

  @AfterEach
  void close() {
    kernel.close();
  }

  private List<String> complete(String text) {
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
    assertEquals(List.of(), complete("missing.he"));
  }

  @Test
  void operatorsAndEverythingAtOnceAreNot() {
    assertFalse(complete("1 + robot.").contains("+"));
    assertEquals(List.of(), complete(""));
    assertEquals(List.of(), complete("robot.head "));
  }

  @Test
  void aClosedLobbyHasNone() {
    connection.close();
    assertEquals(List.of(), complete("ro"));
  }
}
