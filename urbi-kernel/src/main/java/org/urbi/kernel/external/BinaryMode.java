package org.urbi.kernel.external;

import java.util.ArrayDeque;
import java.util.Iterator;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.lobby.MessageInput;
import urbi.wire.WireException;

/**
 * The input of a process in binary mode. Statements may come between the messages, because parts of
 * the SDK ignore the mode.
 */
final class BinaryMode implements MessageInput {
  /**
   * The number of bytes that come first: the sizes of short, int, long and long long in the
   * process.
   */
  private static final int SIZES = 4;

  private static final int SHORT = 2;
  private static final int INT = 4;

  /** The SDK splits longer texts after this many bytes, even within a word. */
  private static final int LONGEST_CODE = 8192;

  /**
   * A step that waits for its turn.
   *
   * @param answer delivers the result of a call, if the step is one; or null
   */
  private record Waiting(Step step, @Nullable Runnable answer, int size) {}

  private final ExternalProcess process;
  private final Consumer<String> broken;
  private final MessageBytes in = new MessageBytes();
  private final MessageReader messages = new MessageReader(in);
  private final ArrayDeque<Waiting> steps = new ArrayDeque<>();
  private @Nullable PlainStatement statement;
  private boolean afterStatement;
  private boolean begun;
  private boolean over;
  private long counted;
  private int answers;
  private int pending;

  /**
   * @param broken called, in turn, with the reason if the input can no longer be understood
   */
  BinaryMode(ExternalProcess process, Consumer<String> broken) {
    this.process = process;
    this.broken = broken;
  }

  @Override
  public void receive(String bytes) {
    if (over) {
      return;
    }
    in.add(bytes);
    try {
      while (read()) {
        // There may be more.
      }
    } catch (WireException e) {
      over = true;
      Command end = frame -> broken.accept(e.getMessage());
      add(end, null);
    }
  }

  /** Reads one thing; false when more input is needed. */
  private boolean read() {
    if (!begun) {
      return begin();
    }
    if (statement == null && messages.isBetween()) {
      if (!in.has(1) || afterStatement && in.peek(0) == '\n' && !in.has(2)) {
        return false;
      }
      if (isStatement()) {
        in.begin();
        statement = new PlainStatement();
      }
    }
    if (statement != null) {
      return readStatement(statement);
    }
    ExternalMessage message = messages.next();
    if (message == null) {
      return false;
    }
    afterStatement = false;
    take(message);
    return true;
  }

  /** The line that asked for the mode may still need its line end. */
  private boolean begin() {
    while (in.has(1) && (in.peek(0) == '\n' || in.peek(0) == '\r' || in.peek(0) == ' ')) {
      in.octet();
    }
    if (!in.has(SIZES)) {
      return false;
    }
    int shorts = in.octet();
    int ints = in.octet();
    in.bytes(SIZES - 2);
    if (shorts != SHORT || ints != INT) {
      throw new WireException(Problem.SIZES_OF_INTEGERS.text(shorts, ints));
    }
    begun = true;
    return true;
  }

  private void take(ExternalMessage message) {
    switch (message) {
      case ExternalMessage.Code code -> add(text(code.text()), null);
      case ExternalMessage.Reply reply -> {
        Runnable answer = () -> process.reply(reply.call(), reply.value(), null);
        Command order = frame -> answer.run();
        add(order, answer);
      }
      case ExternalMessage.Assign assign -> {
        Command order = frame -> process.assign(frame, assign.variable(), assign.value());
        add(order, null);
      }
      case ExternalMessage.Emit emit -> {
        Command order = frame -> process.emit(frame, emit.event(), emit.payload());
        add(order, null);
      }
    }
  }

  private void add(Step step, @Nullable Runnable answer) {
    int size = (int) (in.position() - counted);
    counted = in.position();
    pending += size;
    answers += answer == null ? 0 : 1;
    steps.add(new Waiting(step, answer, size));
  }

  /** A text that ends in an operator is incomplete: the statement continues in the next text. */
  private static Text text(String text) {
    String code = text.stripTrailing();
    boolean goesOn = code.endsWith("|") || code.endsWith("&");
    return goesOn && text.length() != LONGEST_CODE
        ? new Text(code + ";", true)
        : new Text(text, false);
  }

  // ------------------------------------------------------------------ statements in between

  /**
   * Tells the line end behind a statement from a reply, whose code is the same but whose name is
   * short.
   */
  private boolean isStatement() {
    int first = in.peek(0);
    return first >= ' ' || afterStatement && first == '\n' && in.peek(1) != 0;
  }

  private boolean readStatement(PlainStatement reading) {
    while (in.has(1)) {
      if (reading.endsWith((char) in.octet())) {
        if (!reading.code().isEmpty()) {
          add(new Text(reading.code(), false), null);
        }
        statement = null;
        afterStatement = true;
        in.begin();
        return true;
      }
    }
    return false;
  }

  // ------------------------------------------------------------------ out

  @Override
  public @Nullable Step next() {
    Waiting first = steps.poll();
    if (first == null) {
      return null;
    }
    forget(first);
    return first.step;
  }

  private void forget(Waiting done) {
    pending -= done.size;
    answers -= done.answer == null ? 0 : 1;
  }

  @Override
  public boolean hasAnswers() {
    return answers > 0;
  }

  @Override
  public void answer() {
    Iterator<Waiting> waiting = steps.iterator();
    while (answers > 0 && waiting.hasNext()) {
      Waiting each = waiting.next();
      if (each.answer != null) {
        waiting.remove();
        forget(each);
        each.answer.run();
      }
    }
  }

  @Override
  public int pending() {
    return pending;
  }
}
