package org.urbi.server.studio.foxglove;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.BiConsumer;
import org.jspecify.annotations.Nullable;
import org.urbi.server.studio.messages.BadMessage;
import org.urbi.server.studio.messages.Topic;

/** What channels there are for a program, and which of them it wants to be told of. */
final class Subscriptions {
  private static final int MOST = 10_000;

  private final Map<Integer, Topic> topics = new LinkedHashMap<>();

  /** By its number, the channel of each subscription. */
  private final Map<Long, Integer> channels = new HashMap<>();

  /** By their channel, the numbers of subscriptions. */
  private final Map<Integer, List<Long>> subscriptions = new HashMap<>();

  /** The names of the parameters that are to be told when they change. */
  private final Set<String> parameters = new LinkedHashSet<>();

  private final BiConsumer<Integer, Boolean> follow;

  /**
   * @param follow called when somebody wants the first message of a channel, or nobody any more
   */
  Subscriptions(BiConsumer<Integer, Boolean> follow) {
    this.follow = follow;
  }

  void appeared(int channel, Topic topic) {
    topics.put(channel, topic);
    if (parameters.contains(topic.path())) {
      follow.accept(channel, true);
    }
  }

  /** A channel has gone, and all subscriptions of it. */
  void gone(int channel) {
    topics.remove(channel);
    List<Long> ended = subscriptions.remove(channel);
    if (ended != null) {
      ended.forEach(channels::remove);
    }
  }

  @Nullable Topic topic(int channel) {
    return topics.get(channel);
  }

  /** The paths of all variables that are parameters. */
  List<String> parameterNames() {
    return topics.values().stream().filter(Topic::isParameter).map(Topic::path).distinct().toList();
  }

  /** The subscriptions of a channel. */
  List<Long> of(int channel) {
    return subscriptions.getOrDefault(channel, List.of());
  }

  /** Whether the changes of a parameter are to be told. */
  boolean isWatched(Topic topic) {
    return topic.isParameter() && parameters.contains(topic.path());
  }

  /**
   * Begins a subscription.
   *
   * @throws BadMessage if there is no such channel, or the number has been given already
   */
  void subscribe(Request.Subscription wanted) throws BadMessage {
    int channel = (int) wanted.channel();
    if (channel != wanted.channel() || !topics.containsKey(channel)) {
      throw new BadMessage("no such channel: " + wanted.channel());
    }
    if (channels.containsKey(wanted.id())) {
      throw new BadMessage("there is a subscription of that number: " + wanted.id());
    }
    if (channels.size() == MOST || wanted.id() > 0xffff_ffffL) {
      throw new BadMessage("at most " + MOST + " subscriptions, by numbers of 32 bits");
    }
    channels.put(wanted.id(), channel);
    subscriptions.computeIfAbsent(channel, any -> new ArrayList<>(1)).add(wanted.id());
    // Each new one is told the present value.
    follow.accept(channel, true);
  }

  /**
   * Ends a subscription.
   *
   * @throws BadMessage if there is none of that number
   */
  void unsubscribe(long id) throws BadMessage {
    Integer channel = channels.remove(id);
    if (channel == null) {
      throw new BadMessage("no such subscription: " + id);
    }
    List<Long> others = subscriptions.getOrDefault(channel, new ArrayList<>());
    others.remove(id);
    if (others.isEmpty()) {
      subscriptions.remove(channel);
      review(channel);
    }
  }

  /**
   * Begins or ends to tell of the changes of a parameter.
   *
   * @throws BadMessage if there are too many
   */
  void watch(String name, boolean on) throws BadMessage {
    if (on && parameters.size() == MOST) {
      throw new BadMessage("at most " + MOST + " parameters");
    }
    if (on ? parameters.add(name) : parameters.remove(name)) {
      List.copyOf(topics.keySet()).stream()
          .filter(channel -> name.equals(path(channel)))
          .forEach(this::review);
    }
  }

  private String path(int channel) {
    Topic topic = topics.get(channel);
    return topic == null ? "" : topic.path();
  }

  private void review(int channel) {
    Topic topic = topics.get(channel);
    if (topic != null) {
      follow.accept(channel, subscriptions.containsKey(channel) || isWatched(topic));
    }
  }
}
