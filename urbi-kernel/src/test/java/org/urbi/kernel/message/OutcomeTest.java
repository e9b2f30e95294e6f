package org.urbi.kernel.message;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.IOException;
import java.nio.file.NoSuchFileException;
import org.junit.jupiter.api.Test;

/** What work outside of the kernel gives those who asked for it, whatever it throws. */
class OutcomeTest {
  private static Outcome of(Throwable thrown) {
    return new Outcome.Failure(thrown);
  }

  @Test
  void resultIsThatOfTheWork() throws IOException {
    assertEquals("text", Outcome.of(() -> "text").get());
    assertNull(Outcome.of(() -> null).get());
  }

  @Test
  void failuresOfInputAndOutputStayWhatTheyAre() {
    IOException missing = new NoSuchFileException("a");
    Outcome outcome =
        Outcome.of(() -> {
          throw missing;
        });
    assertSame(missing, assertThrows(IOException.class, outcome::get));
  }

  @Test
  void mistakesStayWhatTheyAre() {
    var mistake = new IllegalArgumentException("no");
    assertSame(mistake, assertThrows(IllegalArgumentException.class, of(mistake)::get));
    var error = new LinkageError("missing");
    assertSame(error, assertThrows(LinkageError.class, of(error)::get));
  }

  /** Memory that was not enough for the work must not end the kernel. */
  @Test
  void wantOfMemoryIsAFailureOfTheWork() {
    IOException thrown = assertThrows(IOException.class, of(new OutOfMemoryError())::get);
    assertEquals("memory exhausted", thrown.getMessage());
  }

  @Test
  void otherFailuresAreWrapped() {
    var checked = new InterruptedException();
    assertSame(checked, assertThrows(IOException.class, of(checked)::get).getCause());
  }
}
