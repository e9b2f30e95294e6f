package org.urbi.kernel;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.urbi.kernel.journal.Entry;
import org.urbi.kernel.journal.RecordingReader;
import org.urbi.kernel.message.Message;
import org.urbi.kernel.trust.Role;

/** Clients that hold down the interrupt key while somebody else holds the kernel. */
class InterruptFloodTest {
  private static final int MANY = 100_000;

  @TempDir Path folder;
  private Path recording;
  private Kernel kernel;
  private KernelHold hold;
  private TestClient holder;
  private TestClient impatient;

  @BeforeEach
  void holdTheKernel() throws InterruptedException {
    recording = folder.resolve("run");
    kernel = Kernel.builder().log(line -> {}).record(recording).start();
    hold = new KernelHold(kernel);
    holder = new TestClient(kernel, Role.OWNER);
    impatient = new TestClient(kernel, Role.OWNER);
    assertEquals("1", impatient.say("1;"));
    hold.begin(holder.connection());
  }

  @AfterEach
  void end() {
    hold.end();
    kernel.close();
  }

  /** How many interruptions the kernel has taken in all. */
  private int taken() throws IOException {
    kernel.close();
    int taken = 0;
    try (InputStream file = Files.newInputStream(recording);
        RecordingReader reader = new RecordingReader(file)) {
      for (Entry entry = reader.next(); entry != null; entry = reader.next()) {
        if (entry instanceof Entry.MessageTaken sent
            && sent.message() instanceof Message.Interrupted) {
          taken++;
        }
      }
    }
    return taken;
  }

  @Test
  void onlyOneOfManyWaits() throws IOException {
    for (int i = 0; i < MANY; i++) {
      impatient.connection().interrupt();
    }
    hold.end();
    assertEquals("2", impatient.say("2;"));
    assertEquals(1, taken());
  }

  /** Each drops what has been sent before, so none can stand for those that come later. */
  @Test
  void eachThatFollowsInputWaits() throws IOException {
    for (int i = 0; i < 10; i++) {
      impatient.connection().interrupt();
      impatient.connection().send("1;\n");
    }
    impatient.connection().interrupt();
    hold.end();
    impatient.say("2;");
    assertEquals(11, taken());
  }

  @Test
  void theNextOneIsHeardWhenTheFirstIsOver() throws IOException {
    impatient.connection().interrupt();
    hold.end();
    assertEquals("2", impatient.say("2;"));
    impatient.connection().send("sleep(inf);\n");
    impatient.connection().interrupt();
    String told = impatient.say("3;");
    assertEquals("3", told.substring(told.length() - 1), told);
    assertEquals(2, taken());
  }
}
