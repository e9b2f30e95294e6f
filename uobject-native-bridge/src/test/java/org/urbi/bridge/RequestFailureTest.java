package org.urbi.bridge;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import java.util.logging.Logger;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import urbi.UCastException;

/** Which failures of a request are defects. */
class RequestFailureTest {
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
  void whatTheCodeHasDoneIsToldAlone() {
    assertEquals("no", RequestFailure.text(new IllegalArgumentException("no")));
    assertEquals("no", RequestFailure.text(new UCastException("no")));
    assertEquals("InterruptedException", RequestFailure.text(new InterruptedException()));
    assertEquals(List.of(), logged);
  }

  @Test
  void aDefectIsLoggedAndCalledOne() {
    for (Throwable defect :
        List.of(new NullPointerException("lost"), new NoClassDefFoundError("lost"))) {
      logged.clear();
      assertEquals("internal error: " + defect, RequestFailure.text(defect));
      assertEquals(List.of("internal error in a request of C++ code <- " + defect), logged);
    }
  }
}
