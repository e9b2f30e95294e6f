package org.urbi.server.studio.mcap;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.lang.reflect.Proxy;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.AbstractList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.urbi.kernel.Connection;
import org.urbi.kernel.observe.VariableKind;
import org.urbi.kernel.observe.VariableListener;
import org.urbi.server.TestTimeout;

/** The thread that writes the file fails: who records is told, and nobody waits. */
class McapRecorderTest {
  /** The length of what a file in this format begins and ends with. */
  private static final int MAGIC = 8;

  @TempDir Path folder;

  private final LinkedBlockingQueue<String> log = new LinkedBlockingQueue<>();
  private final CountDownLatch broken = new CountDownLatch(1);
  private @Nullable VariableListener listener;
  private boolean isClosed;

  /** A connection that gives what the recorder listens with. */
  private Connection connection() {
    return (Connection)
        Proxy.newProxyInstance(
            Connection.class.getClassLoader(),
            new Class<?>[] {Connection.class},
            (proxy, method, arguments) -> {
              if (method.getName().equals("feed")) {
                listener = (VariableListener) arguments[0];
              }
              isClosed |= method.getName().equals("close");
              return null;
            });
  }

  private McapRecorder recorder(Path path) throws Exception {
    return new McapRecorder(path, client -> connection(), List.of(), log::add, broken::countDown);
  }

  private void endsAndTells(McapRecorder recorder, String reason) throws Exception {
    String told = log.poll(TestTimeout.LONG.toSeconds(), TimeUnit.SECONDS);
    assertTrue(told != null && told.contains(reason), told);
    assertTrue(told.contains("the recording ends here"), told);
    assertTrue(broken.await(TestTimeout.LONG.toSeconds(), TimeUnit.SECONDS));
    assertFalse(recorder.goesOn());
    listener.value(1, 0, 1.0);
    recorder.close();
    assertTrue(log.remove().contains("were left out"));
  }

  @Test
  void anErrorEndsTheRecording() throws Exception {
    McapRecorder recorder = recorder(folder.resolve("run.mcap"));
    listener.appeared(1, "Global.x", VariableKind.ANY);
    listener.value(
        1,
        0,
        new AbstractList<>() {
          @Override
          public Object get(int index) {
            throw new StackOverflowError("as if it was nested too deeply");
          }

          @Override
          public int size() {
            return 1;
          }
        });
    endsAndTells(recorder, "internal error");
  }

  /** Nobody would take what the kernel tells, so it must not go on telling. */
  @Test
  void withoutAThreadNothingIsRecorded() throws Exception {
    Path path = folder.resolve("run.mcap");
    OutOfMemoryError none = new OutOfMemoryError("unable to create native thread");
    Consumer<Thread> refused =
        thread -> {
          throw none;
        };
    assertSame(
        none,
        assertThrows(
            OutOfMemoryError.class,
            () ->
                new McapRecorder(
                    path,
                    client -> connection(),
                    List.of(),
                    log::add,
                    broken::countDown,
                    refused)));
    assertTrue(isClosed);
    // It is complete: whoever reads it finds the end.
    byte[] written = Files.readAllBytes(path);
    byte[] magic = Arrays.copyOf(written, MAGIC);
    assertArrayEquals(magic, Arrays.copyOfRange(written, written.length - MAGIC, written.length));
  }
}
