package org.urbi.server.console;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.io.OutputStream;
import java.io.PipedInputStream;
import java.io.PipedOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.Collection;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.jline.reader.LineReader;
import org.jline.reader.LineReaderBuilder;
import org.jline.terminal.Size;
import org.jline.terminal.Terminal;
import org.jline.terminal.impl.ExternalTerminal;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.urbi.server.TestTimeout;

/** Somebody who types faster than the kernel answers. */
class CompletionsTest {
  private static final String TAB = "\t";
  private static final String ENTER = "\r";
  private static final String BACKSPACE = "\u007F";

  /** What the terminal shows. */
  private static final class Screen extends OutputStream {
    private final StringBuilder text = new StringBuilder();
    private int seen;

    @Override
    public synchronized void write(int b) {
      text.append((char) b);
      notifyAll();
    }

    /** Waits until something appears behind what was waited for before. */
    synchronized void await(String wanted) throws InterruptedException {
      long end = System.nanoTime() + TestTimeout.LONG.toNanos();
      while (text.indexOf(wanted, seen) < 0) {
        long left = TimeUnit.NANOSECONDS.toMillis(end - System.nanoTime());
        if (left <= 0) {
          throw new AssertionError("no `" + wanted + "' behind " + seen + " of: " + text);
        }
        wait(left);
      }
      seen = text.indexOf(wanted, seen) + wanted.length();
    }
  }

  private final Screen screen = new Screen();
  private final PipedOutputStream keyboard = new PipedOutputStream();
  private final BlockingQueue<CompletableFuture<Collection<String>>> asked =
      new LinkedBlockingQueue<>();
  private Terminal terminal;
  private LineReader reader;

  @BeforeEach
  void open() throws IOException {
    terminal =
        new ExternalTerminal(
            "test", "xterm", new PipedInputStream(keyboard), screen, StandardCharsets.UTF_8);
    terminal.setSize(Size.of(80, 24));
    Completions completions =
        new Completions(text -> {
          CompletableFuture<Collection<String>> names = new CompletableFuture<>();
          asked.add(names);
          return names;
        });
    reader =
        LineReaderBuilder.builder()
            .terminal(terminal)
            .parser(new StatementParser(() -> false, () -> false))
            .completer(completions)
            .build();
    completions.attach(reader);
  }

  @AfterEach
  void close() throws IOException {
    terminal.close();
  }

  private CompletableFuture<String> line() {
    return CompletableFuture.supplyAsync(reader::readLine, Thread::startVirtualThread);
  }

  private void type(String keys) throws IOException {
    keyboard.write(keys.getBytes(StandardCharsets.UTF_8));
    keyboard.flush();
  }

  /** Types a text and asks what it may become; returns what is to be answered. */
  private CompletableFuture<Collection<String>> ask(String text) throws Exception {
    type(text + TAB);
    CompletableFuture<Collection<String>> names =
        asked.poll(TestTimeout.LONG.toSeconds(), TimeUnit.SECONDS);
    if (names == null) {
      throw new AssertionError("nobody asks; on the screen: " + screen.text);
    }
    return names;
  }

  private static String end(CompletableFuture<String> line) throws Exception {
    return line.get(TestTimeout.LONG.toSeconds(), TimeUnit.SECONDS);
  }

  @Test
  void theOnlyNameIsInsertedWhenItComes() throws Exception {
    CompletableFuture<String> line = line();
    CompletableFuture<Collection<String>> names = ask("\"\".toUp");
    type(TAB + "x");
    screen.await("x");
    type(BACKSPACE);
    screen.await("\b");
    names.complete(List.of("toUpper"));
    screen.await("per");
    type(";" + ENTER);
    assertEquals("\"\".toUpper;", end(line));
    assertEquals(0, asked.size(), "who waits does not ask again");
  }

  @Test
  void severalNamesAreListedAboveWhatIsTyped() throws Exception {
    CompletableFuture<String> line = line();
    CompletableFuture<Collection<String>> names = ask("\"\".to");
    type("U");
    screen.await("U");
    type(BACKSPACE);
    screen.await("\b");
    names.complete(List.of("toAscii", "toLower", "toUpper"));
    screen.await("toAscii  toLower  toUpper");
    screen.await("\"\".to");
    type("Lower;" + ENTER);
    assertEquals("\"\".toLower;", end(line));
  }

  @Test
  void anAnswerThatIsNoLongerAskedForChangesNothing() throws Exception {
    CompletableFuture<String> line = line();
    CompletableFuture<Collection<String>> names = ask("\"\".toU");
    type("pp");
    screen.await("pp");
    names.complete(List.of("toUpper"));
    ask("er; \"\".toL").complete(List.of("toLower"));
    screen.await("ower");
    type(";" + ENTER);
    assertEquals("\"\".toUpper; \"\".toLower;", end(line));
  }
}
