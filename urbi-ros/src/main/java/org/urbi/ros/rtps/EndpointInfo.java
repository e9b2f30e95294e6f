package org.urbi.ros.rtps;

import java.net.InetSocketAddress;
import java.util.List;

/**
 * What a participant says about one of its writers or readers.
 *
 * @param isWriter or a reader
 * @param userData what its application tells others about it
 * @param locators where it listens, if not where its participant does
 * @param exclusive whether it wants topics of one owner, which this implementation does not match
 * @param partitions the partitions it is in; none: the default one
 */
public record EndpointInfo(
    Guid guid,
    boolean isWriter,
    String topic,
    String type,
    EndpointQos qos,
    byte[] userData,
    List<InetSocketAddress> locators,
    boolean exclusive,
    List<String> partitions) {

  /**
   * Why this writer does not serve that reader, or the other way round: a policy's name, or "" if
   * it does.
   */
  String hinders(EndpointInfo other) {
    if (exclusive != other.exclusive) return "ownership";
    if (!sharesPartition(other)) return "partition";
    return isWriter ? qos.hinders(other.qos) : other.qos.hinders(qos);
  }

  private boolean sharesPartition(EndpointInfo other) {
    return isInDefaultPartition() && other.isInDefaultPartition()
        || partitions.stream().anyMatch(other.partitions::contains);
  }

  private boolean isInDefaultPartition() {
    return partitions.isEmpty() || partitions.contains("") || partitions.contains("*");
  }

  /** Whether the two speak of the same: a writer and a reader of one topic, with one type. */
  boolean concerns(EndpointInfo other) {
    return isWriter != other.isWriter && topic.equals(other.topic) && type.equals(other.type);
  }
}
