package org.urbi.ros.two;

import org.urbi.ros.rtps.EndpointInfo;

/**
 * Tells of those who use a topic or service of this node with another type: neither hears the
 * other, and nothing else would say why.
 */
final class Mismatches {
  private final Owners owners;
  private final Reports reports;

  Mismatches(Owners owners, Reports reports) {
    this.owners = owners;
    this.reports = reports;
  }

  void compare(EndpointInfo ours, EndpointInfo theirs) {
    if (ours.isWriter() == theirs.isWriter() || !ours.topic().equals(theirs.topic())) return;
    String topic = Mangling.topicOf(ours.topic());
    String service = Mangling.serviceOf(ours.topic());
    if (topic.isEmpty() && service.isEmpty()) return;
    String problem = topic.isEmpty() ? ofService(ours, theirs) : ofTopic(ours, theirs);
    if (problem.isEmpty()) return;
    String name = topic.isEmpty() ? service : topic;
    owners
        .soon(theirs.guid())
        .thenAccept(owner -> reports.tell(name + ": " + owner + " " + problem));
  }

  private static String ofTopic(EndpointInfo ours, EndpointInfo theirs) {
    return problem(
        theirs.isWriter() ? "publishes" : "subscribes to",
        Mangling.typeOf(theirs.type()),
        Mangling.typeOf(ours.type()),
        ours,
        theirs);
  }

  private static String ofService(EndpointInfo ours, EndpointInfo theirs) {
    return problem(
        theirs.isWriter() ? "calls" : "offers",
        Mangling.serviceTypeOf(theirs.type()),
        Mangling.serviceTypeOf(ours.type()),
        ours,
        theirs);
  }

  private static String problem(
      String does, String type, String own, EndpointInfo ours, EndpointInfo theirs) {
    if (!type.equals(own)) return does + " " + type + ", this node has " + own;
    String hash = TwoGraph.hashOf(theirs);
    boolean isSame = hash.isEmpty() || hash.equals(TwoGraph.hashOf(ours));
    return isSame ? "" : does + " " + type + " of another version (" + hash + ")";
  }
}
