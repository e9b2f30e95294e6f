package org.urbi.server.record;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.urbi.kernel.Client;
import org.urbi.kernel.Connection;
import org.urbi.kernel.Kernel;
import org.urbi.kernel.KernelBuilder;
import org.urbi.kernel.journal.Entry;
import org.urbi.kernel.journal.RecordingException;
import org.urbi.kernel.journal.RecordingReader;
import org.urbi.kernel.journal.RecordingWriter;
import org.urbi.kernel.message.Data;
import org.urbi.kernel.message.Message;
import org.urbi.kernel.message.Outcome;
import org.urbi.kernel.observe.CallEnd;
import org.urbi.kernel.trust.Role;
import org.urbi.server.Trace;
import org.urbi.server.net.ConsoleServer;
import org.urbi.server.net.Limits;
import urbi.UClass;
import urbi.UModule;
import urbi.UObject;
import urbi.UVar;
import urbi.remote.RemoteContext;

/**
 * A run is recorded that has two clients, a remote component, a process, a file, real time and
 * random numbers; and replayed where there is none of them.
 */
class RecordedRunTest {
  private static final String HOST = "127.0.0.1";

  @TempDir Path folder;
  private Path recording;

  @BeforeEach
  void chooseFile() {
    recording = folder.resolve("run");
  }

  /** The user's end of a connection. */
  private static final class Console implements Client {
    private final StringBuilder output = new StringBuilder();
    private final CompletableFuture<Void> over = new CompletableFuture<>();
    private final CompletableFuture<Void> left = new CompletableFuture<>();
    private Connection connection;

    @Override
    public synchronized void output(String bytes) {
      output.append(bytes);
      if (bytes.contains("is over")) {
        over.complete(null);
      }
    }

    @Override
    public void closed() {
      over.complete(null);
      left.complete(null);
    }

    synchronized String text() {
      return output.toString();
    }
  }

  private static Console connect(Kernel kernel) {
    Console console = new Console();
    console.connection = kernel.connect(console, false);
    return console;
  }

  /** A component of another process: it adds, and tells what it has added. */
  static final class Adder extends UObject {
    private final UVar last = new UVar();

    Adder(String name) {
      super(name);
      UBindVar(last, "last");
      UBindFunction("add");
    }

    double add(double a, double b) {
      last.setValue(a + b);
      return a + b;
    }
  }

  private static ConsoleServer serve(Kernel kernel) throws IOException {
    return new ConsoleServer(
        new InetSocketAddress(InetAddress.getLoopbackAddress(), 0),
        each -> kernel.connect(each, false),
        kernel::connectRemote,
        Limits.DEFAULT,
        new Trace(
            Trace.Level.NONE,
            new PrintStream(OutputStream.nullOutputStream(), false, StandardCharsets.UTF_8)));
  }

  private String program(Path file) {
    return """
    var turns = 0;
    every (3ms) { turns++ },
    echo("random: " + 1000000.random());
    echo("time: " + System.time + " of " + Date.now);
    echo("file: " + File.new("%1$s").content.data);
    var input = InputStream.new(File.new("%1$s"));
    echo("line: " + input.getLine());
    input.close();
    try { File.new("%1$s/nothing").content } catch (var e) { echo(e.message) };
    var process = Process.new("sh", ["-c", "echo from $HOME; sleep 0.05; exit 3"])|;
    process.run();
    echo("process: " + process.stdout().getLine());
    process.join();
    echo("status: " + process.status());
    var adder = uobjects.Adder.new()|;
    at (adder.last->changed?) echo("last: " + adder.last);
    for (var i = 0; i < 40; i++) { echo("sum: " + adder.add(i, 1)) };
    for (var i = 0; i < 100000; i++) {};
    echo("turns: " + turns + " in " + System.cycle);
    echo("is over");
    """
        .formatted(file);
  }

  /** What each of the connections has shown, by its number. */
  private Map<Integer, String> record() throws Exception {
    Path file = folder.resolve("text");
    Files.writeString(file, "first\nsecond\n");
    Map<Integer, String> shown = new TreeMap<>();
    try (Kernel kernel = Kernel.builder().record(recording).start();
        ConsoleServer server = serve(kernel)) {
      Console one = connect(kernel);
      Console two = connect(kernel);
      RemoteContext remote = new RemoteContext(HOST, server.port());
      remote.start(new UClass("Adder", new UModule("test"), Adder::new));
      two.connection.send("every (10ms) echo(\"tick \" + System.time),\n");
      one.connection.send(program(file));
      one.over.get();
      two.connection.send("echo(40 + 2);\n");
      visit(kernel, "var Global.visited = 1 | echo(\"a visit is over\");\n", Connection::end);
      two.connection.send("echo(\"with input ended: \" + System.lobbies.size);\n");
      visit(kernel, "echo(\"a visit is over\");\n", Connection::close);
      two.connection.send("echo(\"with another gone: \" + System.lobbies.size);\n");
      visit(
          kernel,
          // Told by another job: the interruption meets one that waits, however busy the machine
          // is.
          "{ detach({ sleep(1ms) | echo(\"a visit is over\") }) | sleep(1h) };\n",
          waiting -> {
            waiting.interrupt();
            waiting.end();
          });
      two.connection.send("loop|{},\n");
      // A loop that never lets others run ends by an interruption alone.
      Thread.sleep(50);
      two.connection.interrupt();
      two.connection.send("echo(\"is over\");\n");
      two.over.get();
      kernel.requestShutdown(5);
      assertEquals(5, kernel.awaitTermination());
      remote.close();
      shown.put(-1, one.text());
      shown.put(-2, two.text());
    }
    Files.delete(file);
    return shown;
  }

  /** Another client comes, says something, and leaves so. */
  private static void visit(Kernel kernel, String saying, Consumer<Connection> leaving)
      throws Exception {
    Console visitor = connect(kernel);
    visitor.connection.send(saying);
    visitor.over.get();
    leaving.accept(visitor.connection);
    visitor.left.get();
  }

  private record Replayed(Map<Integer, String> shown, int status, String difference) {}

  private static Replayed replay(Path recording) {
    return replay(recording, UnaryOperator.identity());
  }

  private static Replayed replay(Path recording, UnaryOperator<KernelBuilder> settings) {
    Map<Integer, Console> consoles = new TreeMap<>();
    Kernel kernel =
        settings
            .apply(
                Kernel.builder()
                    .replay(
                        recording, number -> consoles.computeIfAbsent(number, n -> new Console())))
            .start();
    int status = kernel.awaitTermination();
    Map<Integer, String> shown = new TreeMap<>();
    for (int number : new int[] {-1, -2}) {
      shown.put(number, consoles.containsKey(number) ? consoles.get(number).text() : "");
    }
    return new Replayed(shown, status, kernel.replayDifference());
  }

  /** The recording with other entries. */
  private Path changed(UnaryOperator<Entry> change) throws IOException {
    return written(entries().stream().map(change).toList());
  }

  /** The recording with that change. */
  private Path changed(Change change) throws IOException {
    List<Entry> entries = entries();
    boolean found = false;
    int at = 0;
    while (!isOutput(entries.get(at), change.before)) {
      at++;
    }
    while (!found) {
      assertTrue(--at >= 0, change.source + " before " + change.before);
      Entry recorded = entries.get(at);
      entries.set(at, change.made.apply(recorded));
      found = !entries.get(at).equals(recorded);
    }
    return written(entries);
  }

  private static boolean isOutput(Entry entry, String text) {
    return entry instanceof Entry.BytesSent sent
        && new String(sent.head(), StandardCharsets.ISO_8859_1).contains(text);
  }

  private List<Entry> entries() throws IOException {
    List<Entry> entries = new ArrayList<>();
    try (RecordingReader in = new RecordingReader(Files.newInputStream(recording))) {
      for (Entry entry = in.next(); entry != null; entry = in.next()) {
        entries.add(entry);
      }
    }
    return entries;
  }

  private Path written(List<Entry> entries) throws IOException {
    Path other = folder.resolve("changed");
    try (RecordingWriter out =
        new RecordingWriter("changed", Files.newOutputStream(other), trouble -> {})) {
      entries.forEach(out::write);
    }
    return other;
  }

  /**
   * One entry that is another one: the last of its kind before some output.
   *
   * @param source where it is from
   * @param made the other entry; the same for entries that are not meant
   * @param shown what the run shows that was not recorded
   */
  private record Change(String source, String before, UnaryOperator<Entry> made, String shown) {
    /** A message that has not come. */
    static <M extends Message> Change ofMissing(Class<M> kind, String before, String shown) {
      return new Change(
          kind.getSimpleName(),
          before,
          entry ->
              entry instanceof Entry.MessageTaken(Message message) && kind.isInstance(message)
                  ? new Entry.MessageTaken(new Message.ConsoleBytes(message.to(), ""))
                  : entry,
          shown);
    }

    /** A message that is another one. */
    static <M extends Message> Change ofMessage(
        Class<M> kind, String before, UnaryOperator<M> made, String shown) {
      return new Change(
          kind.getSimpleName(),
          before,
          entry ->
              entry instanceof Entry.MessageTaken(Message message) && kind.isInstance(message)
                  ? new Entry.MessageTaken(made.apply(kind.cast(message)))
                  : entry,
          shown);
    }

    /** An answer of the machine that is another one. */
    static <T> Change ofQuery(
        String source, Class<T> kind, String before, UnaryOperator<T> made, String shown) {
      return new Change(
          source,
          before,
          entry ->
              entry instanceof Entry.QueryAnswered(Outcome.Value(Data(var value)))
                      && kind.isInstance(value)
                  ? new Entry.QueryAnswered(Outcome.value(made.apply(kind.cast(value))))
                  : entry,
          shown);
    }
  }

  private static Message.ConnectionOpened observing(Message.ConnectionOpened opened) {
    return new Message.ConnectionOpened(
        opened.connection(),
        opened.holdsTime(),
        opened.address(),
        Role.OBSERVER.name(),
        opened.budget(),
        opened.errors(),
        opened.program(),
        opened.awaited());
  }

  private static final long HOUR = 3_600_000_000_000L;

  private static final List<Change> CHANGES =
      List.of(
          Change.ofMessage(
              Message.ConsoleBytes.class,
              "*** 42",
              sent -> new Message.ConsoleBytes(sent.to(), sent.bytes().replace("40 +", "41 +")),
              "*** 43"),
          Change.ofMessage(
              Message.RemoteFrame.class,
              "sum: 20",
              frame ->
                  new Message.RemoteFrame(
                      frame.to(),
                      ByteBuffer.wrap(frame.frame().clone())
                          .putDouble(frame.frame().length - Double.BYTES, 777)
                          .array()),
              ": 777"),
          Change.ofMessage(
              Message.Answer.class,
              "process: ",
              answer ->
                  new Message.Answer(answer.to(), new Outcome.Failure(new IOException("no shell"))),
              "no shell"),
          Change.ofMessage(
              Message.BytesArrived.class,
              "process: ",
              line ->
                  new Message.BytesArrived(
                      line.to(), "from Mars\n".getBytes(StandardCharsets.US_ASCII)),
              "from Mars"),
          Change.ofMessage(
              Message.ProcessEnded.class,
              "status: ",
              ended -> new Message.ProcessEnded(ended.to(), 4),
              "with status 4"),
          Change.ofMessage(
              Message.ConnectionOpened.class,
              "a visit is over",
              RecordedRunTest::observing,
              "needs the role"),
          Change.ofMissing(Message.InputEnded.class, "with input ended: ", "with input ended: "),
          Change.ofMissing(
              Message.ConnectionClosed.class, "with another gone: ", "with another gone: "),
          Change.ofMissing(
              Message.Interrupted.class, "received interruption", "received interruption"),
          new Change(
              "the clock of a tick",
              "sum: 20",
              entry -> entry instanceof Entry.Tick(long now) ? new Entry.Tick(now + HOUR) : entry,
              ", at 36"),
          // That of a period, perhaps, which is another one then; what is less is no time.
          Change.ofQuery(
              "the clock", Long.class, "time: ", now -> now < 1_000_000 ? now : now + HOUR, "tick"),
          Change.ofQuery(
              "a file",
              byte[].class,
              "line: ",
              bytes -> "another\n".getBytes(StandardCharsets.US_ASCII),
              "line: another"));

  @Test
  void aReplayIsTheRunToTheByte() throws Exception {
    Map<Integer, String> shown = record();
    String one = shown.get(-1);
    for (String word :
        new String[] {
          "random: ", "file: first", "line: first", "from /", "status: ", "last: 40", "sum: 40"
        }) {
      assertTrue(one.contains(word), word + " in " + one);
    }
    assertTrue(shown.get(-2).contains("42"), shown.get(-2));
    Replayed replayed = replay(recording);
    assertNull(replayed.difference());
    assertEquals(shown, replayed.shown());
    assertEquals(5, replayed.status());
    // Compiled code or not makes no difference.
    for (int threshold : new int[] {0, 1, 20}) {
      assertEquals(replayed, replay(recording, kernel -> kernel.tier(threshold)));
    }

    for (Change change : CHANGES) {
      String difference = replay(changed(change)).difference();
      assertTrue(
          difference != null && difference.contains(change.shown),
          () -> change.source + " instead: " + difference);
    }
    String random = replay(recording, kernel -> kernel.seed(2)).difference();
    assertTrue(random != null && random.contains("] *** random: "), random);
  }

  /** As Foxglove does by {@code /call}, and a program that embeds the kernel. */
  @Test
  void aCalledFunctionIsCalledAgain() throws Exception {
    String shown;
    try (Kernel kernel = Kernel.builder().virtualTime(true).record(recording).start()) {
      Console console = connect(kernel);
      console.connection.send(
          "function Global.twice(n) { echo(\"twice \" + n) | sleep(1s) | 2 * n };"
              + " echo(\"the definition is over\");\n");
      console.over.join();
      assertEquals(new CallEnd("", 42.0), console.connection.call("twice", List.of(21.0)).join());
      shown = console.text();
    }
    assertTrue(shown.contains("*** twice 21\n"), shown);
    Replayed replayed = replay(recording);
    assertNull(replayed.difference());
    assertEquals(shown, replayed.shown().get(-1));

    Replayed other =
        replay(
            changed(entry ->
                entry instanceof Entry.MessageTaken(Message.FunctionCalled call)
                    ? new Entry.MessageTaken(
                        new Message.FunctionCalled(
                            call.to(), call.question(), call.path(), new Data(List.of(22.0))))
                    : entry));
    assertNotNull(other.difference());
    assertTrue(other.difference().contains("twice 22"), other.difference());
  }

  // ------------------------------------------------------------------ bad days

  private void recordLittle() {
    try (Kernel kernel = Kernel.builder().virtualTime(true).record(recording).start()) {
      Console console = connect(kernel);
      console.connection.send("for (var i = 0; i < 5; i++) { echo(i); sleep(1h) };\n");
      console.connection.send("echo(\"is over\");\n");
      console.over.join();
    }
  }

  @Test
  void truncatedRecordingIsReplayedUpToItsEnd() throws IOException {
    recordLittle();
    byte[] bytes = Files.readAllBytes(recording);
    Files.write(recording, Arrays.copyOf(bytes, bytes.length - 3));
    Replayed replayed = replay(recording);
    assertTrue(replayed.difference().startsWith("the recording is cut off"), replayed.difference());
  }

  @Test
  void aDamagedRecordingIsRefused() throws IOException {
    recordLittle();
    byte[] bytes = Files.readAllBytes(recording);
    bytes[40] ^= 1;
    Files.write(recording, bytes);
    RecordingException refused = assertThrows(RecordingException.class, () -> replay(recording));
    assertEquals("is damaged at byte 8", refused.getMessage());
  }

  @Test
  void anotherFileIsRefused() throws IOException {
    Files.writeString(recording, "echo(1);\n");
    assertEquals(
        "is no recording of urbi",
        assertThrows(RecordingException.class, () -> replay(recording)).getMessage());
    Files.write(recording, new byte[0]);
    assertEquals(
        "is no recording of urbi",
        assertThrows(RecordingException.class, () -> replay(recording)).getMessage());
  }

  @Test
  void anotherVersionOfTheFormatIsRefused() throws IOException {
    recordLittle();
    byte[] bytes = Files.readAllBytes(recording);
    bytes[7] = 9;
    Files.write(recording, bytes);
    String message = assertThrows(RecordingException.class, () -> replay(recording)).getMessage();
    assertTrue(message.startsWith("has version 9 of the format, not 5"), message);
  }

  /** A full disk is told of once, and the run goes on. */
  @Test
  void fullDiskEndsTheRecordingOnly() throws Exception {
    CompletableFuture<String> told = new CompletableFuture<>();
    OutputStream full =
        new OutputStream() {
          private final ByteArrayOutputStream kept = new ByteArrayOutputStream();

          @Override
          public void write(int b) throws IOException {
            write(new byte[] {(byte) b}, 0, 1);
          }

          @Override
          public void write(byte[] bytes, int from, int length) throws IOException {
            if (kept.size() + length > 100) {
              throw new IOException("No space left on device");
            }
            kept.write(bytes, from, length);
          }
        };
    try (RecordingWriter writer = new RecordingWriter("run", full, told::complete)) {
      for (int i = 0; i < 1000; i++) {
        writer.write(new Entry.Tick(i));
        writer.flush();
      }
    }
    assertEquals("the run is not recorded any more: run: No space left on device", told.get());
  }
}
