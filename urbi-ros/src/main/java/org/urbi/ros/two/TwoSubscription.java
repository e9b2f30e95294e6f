package org.urbi.ros.two;

import java.nio.ByteBuffer;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import org.jspecify.annotations.Nullable;
import org.urbi.ros.codec.CodecException;
import org.urbi.ros.codec.MessageCodec;
import org.urbi.ros.graph.Qos;
import org.urbi.ros.graph.Subscription;
import org.urbi.ros.message.DefinitionException;
import org.urbi.ros.message.MessageType;
import org.urbi.ros.message.TypeHash;
import org.urbi.ros.rtps.EndpointInfo;
import org.urbi.ros.rtps.EndpointQos;
import org.urbi.ros.rtps.Reader;
import org.urbi.ros.rtps.ReaderListener;
import org.urbi.ros.rtps.Sample;
import urbi.UDictionary;
import urbi.thread.GuardedThreads;

/**
 * What this node hears on a topic of ROS 2; its type is that of the first publisher, if it was not
 * said.
 */
final class TwoSubscription implements Subscription {
  private final TwoNode node;
  private final String topic;
  private final Qos qos;
  private final Listener listener;
  private final Reports troubles;
  private final Runnable stopsSeeking;
  private @Nullable Reader reader;
  private boolean closed;

  TwoSubscription(
      TwoNode node, String topic, @Nullable MessageType type, Qos qos, Listener listener) {
    this.node = node;
    this.topic = topic;
    this.qos = qos;
    this.listener = listener;
    troubles = new Reports(listener::failed);
    if (type != null) {
      stopsSeeking = () -> {};
      open(type);
    } else {
      stopsSeeking = node.seek(this::seek);
      seek();
    }
  }

  private void seek() {
    String wanted = Mangling.topic(topic);
    for (EndpointInfo each : node.endpoints()) {
      if (!each.isWriter() || !each.topic().equals(wanted)) continue;
      try {
        MessageType type = node.definitions().message(Mangling.typeOf(each.type()));
        if (open(type)) listener.typed(type);
      } catch (DefinitionException e) {
        troubles.tell(topic, e);
      }
      return;
    }
  }

  /** What is asked of the publishers. */
  private Qos asked() {
    if (!qos.asOffered()) return qos;
    String wanted = Mangling.topic(topic);
    List<EndpointQos> offered =
        node.endpoints().stream()
            .filter(each -> each.isWriter() && each.topic().equals(wanted))
            .map(EndpointInfo::qos)
            .toList();
    return qos.with(
        offered.stream().allMatch(EndpointQos::reliable),
        !offered.isEmpty() && offered.stream().allMatch(EndpointQos::transientLocal));
  }

  private synchronized boolean open(MessageType type) {
    if (closed || reader != null) return false;
    reader =
        node.reader(
            Mangling.topic(topic),
            Mangling.type(type.name()),
            TwoNode.qos(asked()),
            TypeHash.rihs(type),
            new Samples(MessageCodec.of(type)));
    return true;
  }

  @Override
  public String topic() {
    return topic;
  }

  @Override
  public synchronized int publishers() {
    return reader == null ? 0 : reader.matched().size();
  }

  @Override
  public synchronized void close() {
    if (closed) return;
    closed = true;
    stopsSeeking.run();
    if (reader != null) node.close(reader);
  }

  private final class Samples implements ReaderListener {
    private final MessageCodec codec;

    /** What one thread has yet to take: two would mix the order up. */
    private final AtomicInteger arrivals = new AtomicInteger();

    Samples(MessageCodec codec) {
      this.codec = codec;
    }

    @Override
    public void available(Reader us) {
      if (us.info().qos().depth() != EndpointQos.KEEP_ALL) node.takeAll(us, this::received);
      // Where all are wanted, who listens may have us wait, but not all others of this node.
      else if (arrivals.getAndIncrement() == 0)
        GuardedThreads.SDK.virtual("urbi-ros" + topic, () -> takeAll(us)).start();
    }

    private void takeAll(Reader us) {
      int seen;
      do {
        seen = arrivals.get();
        node.takeAll(us, this::received);
      } while (!arrivals.compareAndSet(seen, 0));
    }

    private void received(Sample sample) {
      ByteBuffer bytes = sample.payload();
      if (listener.takes(bytes.asReadOnlyBuffer())) return;
      UDictionary message;
      try {
        message = codec.decode(bytes);
      } catch (CodecException e) {
        String owner = node.owners().now(sample.identity().writer());
        troubles.tell(owner + " sends what is no " + codec.type().name() + ": " + e.getMessage());
        return;
      }
      listener.received(message);
    }

    @Override
    public void hindered(Reader us, EndpointInfo writer, String policy) {
      node.owners()
          .soon(writer.guid())
          .thenAccept(owner ->
              troubles.tell(owner + " does not offer the " + policy + " that is asked for"));
    }
  }
}
