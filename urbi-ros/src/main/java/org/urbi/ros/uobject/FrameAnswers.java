package org.urbi.ros.uobject;

import java.util.concurrent.CompletionStage;
import org.urbi.ros.frames.FrameBuffer;
import org.urbi.ros.frames.FrameListener;
import org.urbi.ros.frames.Transform;
import org.urbi.ros.graph.RosException;
import org.urbi.ros.message.Templates;
import urbi.UDataType;
import urbi.UDictionary;
import urbi.UValue;

/** Where frames are, as urbiscript asks for it and is told. */
final class FrameAnswers {
  private static final double NANOSECONDS = 1e9;
  private static final double MOST = Long.MAX_VALUE / NANOSECONDS / 2;

  private FrameAnswers() {}

  /**
   * What is asked.
   *
   * @param time nanoseconds; 0 for the newest one that is known
   * @param patience milliseconds
   */
  record Question(String target, String source, long time, long patience) {
    /**
     * As urbiscript asks.
     *
     * @param time seconds, or as messages have it
     * @param patience seconds
     * @throws RosException if one of them is no time
     */
    static Question of(String target, String source, UValue time, double patience) {
      if (!(patience >= 0)) {
        throw new RosException("patience: seconds expected, 0 or more, not " + patience);
      }
      return new Question(target, source, nanoseconds(time), (long) Math.ceil(patience * 1000));
    }

    /** The answer, as {@code geometry_msgs/TransformStamped}. */
    CompletionStage<UDictionary> ask(FrameListener frames) {
      return frames
          .lookup(target, source, time, patience)
          .thenApply(found -> stamped(target, source, found));
    }
  }

  private static long nanoseconds(UValue time) {
    if (time.getType() == UDataType.DATA_DICTIONARY) {
      return Templates.nanoseconds(time.udictionaryValue());
    }
    double seconds = time.getType() == UDataType.DATA_DOUBLE ? time.doubleValue() : -1;
    if (!(seconds >= 0 && seconds < MOST)) {
      throw new RosException("time: seconds, or a stamp as messages have it, expected");
    }
    return (long) (seconds * NANOSECONDS);
  }

  private static UDictionary stamped(String target, String source, FrameBuffer.Found found) {
    Transform transform = found.transform();
    UDictionary moved =
        new UDictionary()
            .with("x", transform.x())
            .with("y", transform.y())
            .with("z", transform.z());
    UDictionary turned =
        new UDictionary()
            .with("x", transform.qx())
            .with("y", transform.qy())
            .with("z", transform.qz())
            .with("w", transform.qw());
    return new UDictionary()
        .with(
            "header",
            new UDictionary().with("stamp", Templates.time(found.time())).with("frame_id", target))
        .with("child_frame_id", source)
        .with("transform", new UDictionary().with("translation", moved).with("rotation", turned));
  }
}
