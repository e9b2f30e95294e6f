package org.urbi.ros.frames;

import static java.util.Objects.requireNonNull;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import org.urbi.ros.graph.Node;
import org.urbi.ros.graph.Qos;
import org.urbi.ros.graph.RosException;
import org.urbi.ros.graph.Subscription;
import org.urbi.ros.message.MessageType;
import org.urbi.ros.message.Templates;
import urbi.UDictionary;
import urbi.UValue;

/** Hears where frames are, on {@code /tf} and {@code /tf_static}, and answers who wants to know. */
public final class FrameListener {
  /** Questions that wait at most. */
  private static final int MOST = 1000;

  /** Nanoseconds by which time has to jump back to be another one. */
  private static final long JUMP = 1_000_000_000L;

  private static final Qos MOVING = new Qos(true, false, 100, Qos.DEFAULT.deadline(), true);
  private static final Qos FIXED = new Qos(true, true, 100, Qos.DEFAULT.deadline(), false);

  /** What somebody wants to know. */
  private record Asked(
      String target, String source, long time, CompletableFuture<FrameBuffer.Found> answer) {}

  private final Node node;
  private final Consumer<String> people;
  private final FrameBuffer buffer = new FrameBuffer();
  private final List<Asked> waiting = new ArrayList<>();
  private long now = Long.MIN_VALUE;
  private String trouble = "";

  /**
   * Begins to listen.
   *
   * @param people are told what is wrong with what is heard
   */
  public FrameListener(Node node, Consumer<String> people) {
    this.node = node;
    this.people = people;
    MessageType type = node.definitions().message("tf2_msgs/TFMessage");
    node.subscribe("/tf", type, MOVING, listener(false));
    node.subscribe("/tf_static", type, FIXED, listener(true));
  }

  /** What is known. */
  public FrameBuffer buffer() {
    return buffer;
  }

  private Subscription.Listener listener(boolean fixed) {
    return new Subscription.Listener() {
      @Override
      public void received(UDictionary message) {
        heard(message, fixed);
      }

      @Override
      public void failed(String reason) {
        tell(reason);
      }
    };
  }

  private synchronized void tell(String reason) {
    if (!reason.equals(trouble)) {
      trouble = reason;
      people.accept(reason);
    }
  }

  private void heard(UDictionary message, boolean fixed) {
    checkTime();
    for (UValue each : part(message, "transforms").ulistValue()) {
      UDictionary told = each.udictionaryValue();
      UDictionary header = part(told, "header").udictionaryValue();
      try {
        buffer.put(
            part(header, "frame_id").stringValue(),
            part(told, "child_frame_id").stringValue(),
            transform(part(told, "transform").udictionaryValue()),
            Templates.nanoseconds(part(header, "stamp").udictionaryValue()),
            fixed);
      } catch (FrameException e) {
        tell((fixed ? "/tf_static: " : "/tf: ") + e.getMessage());
      }
    }
    answerAll();
  }

  /** A simulation that begins again tells of what was never before. */
  private synchronized void checkTime() {
    long time = node.now();
    if (time < now - JUMP) {
      buffer.clear();
    }
    now = time;
  }

  private static Transform transform(UDictionary told) {
    UDictionary moved = part(told, "translation").udictionaryValue();
    UDictionary turned = part(told, "rotation").udictionaryValue();
    return new Transform(
        number(moved, "x"),
        number(moved, "y"),
        number(moved, "z"),
        number(turned, "x"),
        number(turned, "y"),
        number(turned, "z"),
        number(turned, "w"));
  }

  private static double number(UDictionary message, String name) {
    return part(message, name).doubleValue();
  }

  private static UValue part(UDictionary message, String name) {
    return requireNonNull(message.get(name), "a decoded message has all its fields");
  }

  // ------------------------------------------------------------------ who wants to know

  /**
   * Where {@code source} was in {@code target}, as soon as that is known.
   *
   * @param time nanoseconds since 1970, or {@link FrameBuffer#NEWEST}
   * @param patience milliseconds after which it fails with a {@link FrameException}: what is
   *     missing
   */
  public CompletableFuture<FrameBuffer.Found> lookup(
      String target, String source, long time, long patience) {
    CompletableFuture<FrameBuffer.Found> answer = new CompletableFuture<>();
    Asked asked = new Asked(target, source, time, answer);
    synchronized (waiting) {
      if (waiting.size() >= MOST) {
        throw new RosException("more than " + MOST + " wait to be told where a frame is");
      }
      waiting.add(asked);
    }
    answer.whenComplete((found, failure) -> forget(asked));
    answerAll();
    if (!answer.isDone()) {
      CompletableFuture.delayedExecutor(patience, TimeUnit.MILLISECONDS)
          .execute(() -> answer(asked, true));
    }
    return answer;
  }

  private void forget(Asked asked) {
    synchronized (waiting) {
      waiting.remove(asked);
    }
  }

  private void answerAll() {
    List<Asked> all;
    synchronized (waiting) {
      all = List.copyOf(waiting);
    }
    all.forEach(each -> answer(each, false));
  }

  private void answer(Asked asked, boolean isLast) {
    try {
      asked.answer.complete(buffer.lookup(asked.target, asked.source, asked.time));
    } catch (FrameException e) {
      if (isLast) {
        asked.answer.completeExceptionally(e);
      }
    }
  }
}
