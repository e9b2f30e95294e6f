package org.urbi.kernel.tag;

import org.urbi.kernel.error.UrbiException;
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
    if (!(value instanceof UrbiTag label)) {
      var interpreter = frame.interpreter();
      throw frame.located(
          interpreter.errors().argumentType("tag", 0, value, interpreter.prototypes().tag, "Tag"),
          tag.span());
    }
    return run(frame, label, body);
  }

  /** Executes code under a tag, and under the tags that it stands under. */
  public static UrbiObject run(Frame frame, UrbiTag tag, Node body) {
    if (tag.parent() == null) {
      return runUnder(frame, tag, body);
    }
    return run(
        frame,
        tag.parent(),
        new Node(body.span()) {
          @Override
          public UrbiObject execute(Frame inner) {
            return runUnder(inner, tag, body);
          }
        });
  }

  private static UrbiObject runUnder(Frame frame, UrbiTag tag, Node body) {
    Job job = frame.job();
    if (tag.state().isBlocked()) {
      return tag.state().blockedValue();
    }
    TagScope scope = job.enter(tag.state());
    boolean entered = false;
    try {
      job.holdIfFrozen();
      tag.entering(frame);
      entered = true;
      if (tag.enterEvent() != null) {
        tag.enterEvent().emit(job, true);
      }
      return body.execute(frame);
    } catch (TagStop stop) {
      if (stop.scope() != scope) {
        throw stop;
      }
      return stopped(frame, tag, stop.value(), body);
    } finally {
      job.leave(scope);
      if (entered) {
        tag.left(frame);
      }
      if (tag.leaveEvent() != null) {
        tag.leaveEvent().emit(job, true);
      }
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
