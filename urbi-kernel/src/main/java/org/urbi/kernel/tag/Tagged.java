package org.urbi.kernel.tag;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.event.UrbiEvent;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.TagScope;
import org.urbi.kernel.job.TagStop;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.Node;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.lang.source.Span;

/** {@code tag: body}. */
public final class Tagged extends Node {
  private final Node tag;
  private final Node body;

  public Tagged(Span span, Node tag, Node body) {
    super(span);
    this.tag = tag;
    this.body = body;
  }

  @Override
  public UrbiObject execute(Frame frame) {
    UrbiObject value = tag.execute(frame);
    if (value == frame.interpreter().values().voidObject) {
      throw frame.located(frame.interpreter().errors().unexpectedVoid(), span());
    }
    if (!(value instanceof UrbiTag label)) {
      var interpreter = frame.interpreter();
      throw frame.located(interpreter.errors().type(value, interpreter.prototypes().tag), span());
    }
    return run(frame, label, body);
  }

  /** Executes code under a tag and its parent tags. */
  public static UrbiObject run(Frame frame, UrbiTag tag, Node body) {
    List<UrbiTag> tags = new ArrayList<>();
    for (UrbiTag at = tag; at != null; at = at.parent()) {
      tags.addFirst(at);
    }
    return run(frame, tags, 0, new boolean[tags.size()], body);
  }

  /**
   * Enters the tags from the outermost to the innermost. Their events are emitted only when no tag
   * blocks or freezes the code.
   *
   * @param told the tags that have been notified of the code entering
   */
  private static UrbiObject run(
      Frame frame, List<UrbiTag> tags, int index, boolean[] told, Node body) {
    Job job = frame.job();
    if (index == tags.size()) {
      job.waitWhileFrozen();
      enter(frame, tags, told);
      return body.execute(frame);
    }
    UrbiTag tag = tags.get(index);
    UrbiObject blocked = tag.state().blockedValue();
    if (blocked != null) {
      return blocked;
    }
    double before = job.priority();
    job.setPriority(Math.max(before, tag.priority()));
    TagScope scope = job.enter(tag.state());
    try {
      return run(frame, tags, index + 1, told, body);
    } catch (TagStop stop) {
      if (stop.scope() != scope) {
        throw stop;
      }
      return stopped(frame, tag, stop.value(), body);
    } finally {
      job.leave(scope);
      job.setPriority(before);
      if (told[index]) {
        tag.left(frame);
        emit(tag.leaveEvent(), job);
      }
    }
  }

  private static void enter(Frame frame, List<UrbiTag> tags, boolean[] told) {
    for (int i = 0; i < told.length; i++) {
      tags.get(i).entering(frame);
      told[i] = true;
      emit(tags.get(i).enterEvent(), frame.job());
    }
  }

  private static void emit(@Nullable UrbiEvent event, Job job) {
    if (event != null) {
      event.emit(job, true);
    }
  }

  private static UrbiObject stopped(Frame frame, UrbiTag tag, UrbiObject value, Node body) {
    try {
      return tag.stopped(frame, value);
    } catch (UrbiException e) {
      throw frame.located(e, body.span());
    }
  }
}
