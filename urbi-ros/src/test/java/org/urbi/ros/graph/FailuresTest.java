package org.urbi.ros.graph;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletionException;
import java.util.logging.Logger;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.urbi.ros.two.Reports;

/** What is told, and what is logged besides. */
class FailuresTest {
  private final Logger log = Logger.getLogger("UObjectJava");
  private final List<String> logged = new ArrayList<>();

  @BeforeEach
  void listen() {
    log.setFilter(entry -> !logged.add(entry.getMessage() + " <- " + entry.getThrown()));
  }

  @AfterEach
  void stopListening() {
    log.setFilter(null);
  }

  @Test
  void theFaultsOfOthersAreTold() {
    assertEquals("no", Failures.told("a test", new RosException("no")));
    assertEquals(
        "reset", Failures.told("a test", new CompletionException(new IOException("reset"))));
    assertEquals(List.of(), logged);
  }

  @Test
  void aDefectIsLoggedToo() {
    Throwable defect = new CompletionException(new NullPointerException("of ours"));
    assertEquals(
        "internal error: java.lang.NullPointerException: of ours", Failures.told("a test", defect));
    assertEquals(
        List.of("internal error in a test <- java.lang.NullPointerException: of ours"), logged);
  }

  @Test
  void theSameDefectIsReportedOnce() {
    List<String> people = new ArrayList<>();
    Reports reports = new Reports(people::add);
    for (int i = 0; i < 2; i++) {
      reports.tell("a topic", new NoClassDefFoundError("lost"));
    }
    assertEquals(List.of("a topic: internal error: java.lang.NoClassDefFoundError: lost"), people);
    assertEquals(
        List.of("internal error in a topic <- java.lang.NoClassDefFoundError: lost"), logged);
  }
}
