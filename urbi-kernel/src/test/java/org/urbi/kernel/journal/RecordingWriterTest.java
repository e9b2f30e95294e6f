package org.urbi.kernel.journal;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.OutputStream;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.urbi.kernel.TestTimeout;

class RecordingWriterTest {
  /** Somebody hears of it, and the run goes on without being recorded. */
  @Test
  void anErrorOfItsThreadIsTold() throws Exception {
    CompletableFuture<String> trouble = new CompletableFuture<>();
    OutputStream broken =
        new OutputStream() {
          @Override
          public void write(int b) {
            throw new NoClassDefFoundError("org/nowhere/Disk");
          }
        };
    try (RecordingWriter writer = new RecordingWriter("run", broken, trouble::complete)) {
      String told = trouble.get(TestTimeout.LONG.toSeconds(), TimeUnit.SECONDS);
      assertTrue(told.startsWith("the run is not recorded any more: run: internal error: "), told);
      writer.write(new Entry.RoundCut(1, 0));
      writer.flush();
    }
  }
}
