package org.urbi.ros.graph;

import static java.util.Objects.requireNonNull;

import java.util.function.LongSupplier;
import org.jspecify.annotations.Nullable;
import org.urbi.ros.message.MessageType;
import org.urbi.ros.message.Templates;
import urbi.UDictionary;
import urbi.UValue;

/**
 * What time it is for a node: that of people or, if its {@code use_sim_time} is set, the one that
 * is told on {@code /clock}, which may stand still, jump, or run at another speed.
 */
public final class ClockFollower {
  /** The parameter that says which it is. */
  public static final String PARAMETER = "use_sim_time";

  private static final String TOPIC = "/clock";
  private static final Qos NEWEST = new Qos(false, false, 1, Qos.DEFAULT.deadline(), false);

  private final Node node;
  private final LongSupplier people;
  private volatile long told;
  private volatile @Nullable Subscription subscription;

  /**
   * @param people the time of people, in nanoseconds since 1970
   */
  public ClockFollower(Node node, LongSupplier people) {
    this.node = node;
    this.people = people;
  }

  /** Nanoseconds since 1970; 0 as long as {@code /clock} is followed and has told nothing. */
  public long nanoseconds() {
    return subscription == null ? people.getAsLong() : told;
  }

  /** Begins to follow {@code /clock}, or ends it. */
  public synchronized void follow(boolean wanted) {
    Subscription present = subscription;
    if (wanted && present == null) {
      told = 0;
      MessageType type = node.definitions().message("rosgraph_msgs/Clock");
      subscription = node.subscribe(TOPIC, type, NEWEST, this::received);
    } else if (!wanted && present != null) {
      subscription = null;
      present.close();
    }
  }

  private void received(UDictionary message) {
    UValue clock = requireNonNull(message.get("clock"), "a decoded message has all its fields");
    told = Templates.nanoseconds(clock.udictionaryValue());
  }
}
