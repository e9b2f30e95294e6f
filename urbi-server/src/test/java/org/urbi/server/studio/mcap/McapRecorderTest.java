package org.urbi.server.studio.mcap;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.lang.reflect.Proxy;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.AbstractList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.urbi.kernel.Connection;
import org.urbi.kernel.job.Turn;
import org.urbi.kernel.job.Wait;
import org.urbi.kernel.observe.JobRow;
import org.urbi.kernel.observe.TagRow;
import org.urbi.kernel.observe.TurnView;
import org.urbi.kernel.observe.VariableKind;
import org.urbi.kernel.observe.VariableListener;
import org.urbi.kernel.observe.View;
import org.urbi.kernel.observe.ViewRequest;
import org.urbi.server.TestTimeout;

/**
 * What is written of the jobs; and if the thread that writes fails, who records is told, and nobody
 * waits.
 */
class McapRecorderTest {
  /** The length of what a file in this format begins and ends with. */
  private static final int MAGIC = 8;

  /** A look at the jobs that the kernel was asked for. */
  private record Look(ViewRequest wanted, CompletableFuture<View> answer) {}

  @TempDir Path folder;

  private final LinkedBlockingQueue<String> log = new LinkedBlockingQueue<>();
  private final CountDownLatch broken = new CountDownLatch(1);
  private final LinkedBlockingQueue<Look> looks = new LinkedBlockingQueue<>();
  private @Nullable VariableListener listener;
  private @Nullable Consumer<View> end;
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
              if (method.getName().equals("lookAtEnd")) {
                end = views(arguments[1]);
              }
              isClosed |= method.getName().equals("close");
              if (method.getName().equals("look")) {
                Look look = new Look((ViewRequest) arguments[0], new CompletableFuture<>());
                looks.add(look);
                return look.answer;
              }
              return null;
            });
  }

  @SuppressWarnings("unchecked") // a proxy is given arguments whatever their types
  private static Consumer<View> views(Object argument) {
    return (Consumer<View>) argument;
  }

  private McapRecorder recorder(Path path) throws Exception {
    return new McapRecorder(
        path, client -> connection(), List.of(), true, log::add, broken::countDown);
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
    assertFalse(isOpen(folder.resolve("run.mcap")), "it is of no use any more");
  }

  /** Whether this process has a file open. */
  private static boolean isOpen(Path file) throws IOException {
    try (Stream<Path> descriptors = Files.list(Path.of("/proc/self/fd"))) {
      return descriptors.anyMatch(each -> leadsTo(each, file));
    }
  }

  private static boolean leadsTo(Path descriptor, Path file) {
    try {
      return Files.readSymbolicLink(descriptor).equals(file);
    } catch (IOException e) {
      // It was that of the list of descriptors.
      return false;
    }
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
                    true,
                    log::add,
                    broken::countDown,
                    refused)));
    assertTrue(isClosed);
    // It is complete: whoever reads it finds the end.
    byte[] written = Files.readAllBytes(path);
    byte[] magic = Arrays.copyOf(written, MAGIC);
    assertArrayEquals(magic, Arrays.copyOfRange(written, written.length - MAGIC, written.length));
  }

  private static View view(
      List<JobRow> jobs, List<Long> gone, List<TagRow> tags, TurnView turns, boolean complete) {
    return new View(
        5_000_000_000L, 0, 0, 2, jobs, gone, tags, List.of(), turns, null, null, null, complete);
  }

  private static JobRow job(long number, String name, long... tags) {
    List<Long> under = Arrays.stream(tags).boxed().toList();
    return new JobRow(number, name, 1, "lobby", "event", false, "a.u:1", "at (e?)", under, 0);
  }

  private String written(Path path) throws Exception {
    return Files.readString(path, StandardCharsets.ISO_8859_1);
  }

  @Test
  void jobsAndTheirTurnsAreInTheFile() throws Exception {
    Path path = folder.resolve("run.mcap");
    McapRecorder recorder = recorder(path);
    Look first = looks.take();
    assertTrue(first.wanted.traced().isEmpty());
    TurnView none = new TurnView(List.of(), 0, null);
    first.answer.complete(view(List.of(job(3, "worker", 7)), List.of(), List.of(), none, false));
    Look second = looks.take();
    assertEquals(List.of(3L), second.wanted.traced(), "its turns are wanted from now on");
    TagRow tag = new TagRow(7, "mine", false, false);
    Turn turn = new Turn(3, List.of(2L, 1L), 1_500_000_000L, 1_750_000_000L, Wait.EVENT, true);
    TurnView turns = new TurnView(List.of(turn), 1_250_000_000L, Map.of(3L, 1_000_000_000L));
    second.answer.complete(view(List.of(job(4, "other")), List.of(), List.of(tag), turns, true));
    looks.take();
    recorder.close();
    String bytes = written(path);
    assertTrue(bytes.contains("urbi.Jobs") && bytes.contains("urbi.Turns"), bytes);
    assertTrue(bytes.contains("\"total\":2.0"), bytes);
    assertTrue(bytes.contains("\"name\":\"worker\""), bytes);
    assertTrue(bytes.contains("\"tags\":[\"mine\"]"), bytes);
    String told =
        "{\"machine\":5.0,\"lostUntil\":1.25,\"traced\":[{\"job\":3.0,\"since\":1.0}],"
            + "\"turns\":[{\"job\":3.0,\"begin\":1.5,\"end\":1.75,\"waited\":\"event\","
            + "\"wakers\":[2.0,1.0],\"ended\":true}]}";
    assertTrue(bytes.contains(told), bytes);
  }

  /** What was seen and not yet written is not lost, and the kernel is not asked again for it. */
  @Test
  void whatWasSeenBeforeTheEndIsWritten() throws Exception {
    Path path = folder.resolve("run.mcap");
    McapRecorder recorder = recorder(path);
    TurnView none = new TurnView(List.of(), 0, null);
    looks.take().answer.complete(view(List.of(job(3, "late")), List.of(), List.of(), none, true));
    recorder.close();
    assertTrue(written(path).contains("\"name\":\"late\""));
    assertTrue(log.isEmpty(), log::toString);
  }

  /**
   * The kernel tells at its end what nobody has asked for; what it was asked for before that, and
   * has answered, comes first.
   */
  @Test
  void whatTheKernelTellsAtItsEndIsWritten() throws Exception {
    Path path = folder.resolve("run.mcap");
    McapRecorder recorder = recorder(path);
    TurnView none = new TurnView(List.of(), 0, null);
    looks.take().answer.complete(view(List.of(job(3, "early")), List.of(), List.of(), none, true));
    end.accept(view(List.of(job(4, "late")), List.of(), List.of(), none, false));
    Turn turn = new Turn(4, List.of(), 1_500_000_000L, 1_750_000_000L, Wait.EVENT, true);
    TurnView turns = new TurnView(List.of(turn), 0, null);
    end.accept(view(List.of(), List.of(3L), List.of(), turns, true));
    recorder.closeOrAbandon();
    String bytes = written(path);
    assertTrue(bytes.contains("\"total\":1.0,\"jobs\":[{\"number\":4.0"), bytes);
    assertTrue(bytes.indexOf("\"name\":\"early\"") < bytes.indexOf("\"name\":\"late\""), bytes);
    assertTrue(bytes.contains("\"end\":1.75"), bytes);
  }

  private static Thread stopping(McapRecorder recorder) {
    Thread stopping = Thread.ofPlatform().start(recorder::stop);
    while (stopping.getState() != Thread.State.WAITING) {
      Thread.onSpinWait();
    }
    return stopping;
  }

  /** What was done after the last look is seen by one more, however many parts that has. */
  @Test
  void theLastMomentBeforeAStopIsWritten() throws Exception {
    Path path = folder.resolve("run.mcap");
    McapRecorder recorder = recorder(path);
    Look before = looks.take();
    Thread stopping = stopping(recorder);
    TurnView none = new TurnView(List.of(), 0, null);
    before.answer.complete(view(List.of(job(3, "early")), List.of(), List.of(), none, true));
    Look part = looks.take();
    assertEquals(List.of(3L), part.wanted.traced());
    part.answer.complete(view(List.of(job(4, "late")), List.of(), List.of(), none, false));
    Turn turn = new Turn(3, List.of(), 1_500_000_000L, 1_750_000_000L, Wait.EVENT, true);
    TurnView turns = new TurnView(List.of(turn), 0, null);
    looks.take().answer.complete(view(List.of(), List.of(), List.of(), turns, true));
    stopping.join();
    String bytes = written(path);
    assertTrue(bytes.contains("\"name\":\"late\""), bytes);
    assertTrue(bytes.contains("\"end\":1.75"), bytes);
    assertTrue(looks.isEmpty() && isClosed);
  }

  /** As one that is held: the file is complete all the same. */
  @Test
  void aKernelThatDoesNotAnswerIsLeftAlone() throws Exception {
    Path path = folder.resolve("run.mcap");
    McapRecorder recorder = recorder(path);
    looks.take();
    recorder.stop();
    byte[] written = Files.readAllBytes(path);
    byte[] magic = Arrays.copyOf(written, MAGIC);
    assertArrayEquals(magic, Arrays.copyOfRange(written, written.length - MAGIC, written.length));
    assertTrue(looks.isEmpty() && log.isEmpty());
  }

  /** A kernel that is busy, or a disk that is slow, is asked for one look, not for many. */
  @Test
  void thereIsOneLookAtATime() throws Exception {
    Path path = folder.resolve("run.mcap");
    McapRecorder recorder = recorder(path);
    Look unanswered = looks.take();
    listener.appeared(1, "Global.x", VariableKind.NUMBER);
    listener.value(1, 0, 1.0);
    // It is in the file a second later: until then the look was due again many times.
    while (!written(path).contains("/Global/x")) {
      Thread.onSpinWait();
    }
    assertTrue(looks.isEmpty(), "one look at a time");
    unanswered.answer.cancel(false);
    recorder.close();
    assertTrue(log.isEmpty(), "that the connection was closed is no failure");
  }

  @Test
  void aDefectInLookingIsTold() throws Exception {
    McapRecorder recorder = recorder(folder.resolve("run.mcap"));
    listener.appeared(1, "Global.x", VariableKind.ANY);
    looks.take().answer.completeExceptionally(new IllegalStateException("as if of ours"));
    endsAndTells(recorder, "internal error");
  }

  /** What is no regular file may have whoever writes wait for ever. */
  @ParameterizedTest
  @ValueSource(strings = {"pipe", ".", "/dev/null"})
  void onlyRegularFilesAreWritten(String name) throws Exception {
    Path pipe = folder.resolve("pipe");
    assertEquals(0, new ProcessBuilder("mkfifo", pipe.toString()).start().waitFor());
    IOException refused = assertThrows(IOException.class, () -> recorder(folder.resolve(name)));
    assertTrue(String.valueOf(refused.getMessage()).contains("not a regular file"));
  }

  /** Whoever ends the process does not wait for a disk that hangs. */
  @Test
  void whatHangsIsAbandonedAtTheEnd() throws Exception {
    McapRecorder recorder = recorder(folder.resolve("run.mcap"));
    CountDownLatch begun = new CountDownLatch(1);
    CountDownLatch interrupted = new CountDownLatch(1);
    listener.appeared(1, "Global.x", VariableKind.ANY);
    listener.value(
        1,
        0,
        new AbstractList<>() {
          @Override
          public Object get(int index) {
            begun.countDown();
            try {
              Thread.currentThread().join();
            } catch (InterruptedException e) {
              interrupted.countDown();
              Thread.currentThread().interrupt();
            }
            return 1.0;
          }

          @Override
          public int size() {
            return 1;
          }
        });
    listener.value(1, 1, 1.0);
    listener.value(1, 2, 2.0);
    begun.await();
    recorder.closeOrAbandon(Duration.ZERO);
    assertTrue(isClosed);
    assertTrue(log.take().contains("the recording is not complete"));
    assertTrue(log.take().contains("2 values were left out"));
    interrupted.await();
  }
}
