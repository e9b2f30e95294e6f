package org.urbi.ros.two;

import java.nio.ByteBuffer;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import org.urbi.ros.codec.MessageCodec;
import org.urbi.ros.graph.Publisher;
import org.urbi.ros.graph.Qos;
import org.urbi.ros.message.MessageType;
import org.urbi.ros.message.TypeHash;
import org.urbi.ros.rtps.EndpointInfo;
import org.urbi.ros.rtps.Guid;
import org.urbi.ros.rtps.Writer;
import org.urbi.ros.rtps.WriterListener;
import urbi.UDictionary;

/** What this node says on a topic of ROS 2. */
final class TwoPublisher implements Publisher {
  /** Nothing waits for slow subscribers: where all are wanted, there is an end somewhere. */
  private static final int MOST = 1000;

  private final TwoNode node;
  private final String topic;
  private final MessageCodec codec;
  private final Listener listener;
  private final Reports troubles;
  private final Map<Guid, CompletableFuture<Void>> subscribed = new ConcurrentHashMap<>();
  private final Map<Guid, String> names = new ConcurrentHashMap<>();
  private final Writer writer;

  TwoPublisher(TwoNode node, String topic, MessageType type, Qos qos, Listener listener) {
    this.node = node;
    this.topic = topic;
    this.listener = listener;
    troubles = new Reports(listener::failed);
    codec = MessageCodec.of(type);
    writer =
        node.writer(
            Mangling.topic(topic),
            Mangling.type(type.name()),
            TwoNode.qos(qos.atMost(MOST)),
            TypeHash.rihs(type),
            new Readers());
  }

  @Override
  public String topic() {
    return topic;
  }

  @Override
  public MessageType type() {
    return codec.type();
  }

  @Override
  public void publish(UDictionary message) {
    writer.write(ByteBuffer.wrap(codec.encode(message)));
  }

  @Override
  public int subscribers() {
    return writer.matched().size();
  }

  @Override
  public void close() {
    node.close(writer);
  }

  private final class Readers implements WriterListener {
    @Override
    public void matched(Writer us, EndpointInfo reader) {
      Guid guid = reader.guid();
      CompletableFuture<Void> told =
          node.owners()
              .soon(guid)
              .thenAccept(owner -> {
                names.put(guid, owner);
                listener.connected(owner);
              });
      subscribed.put(guid, told);
    }

    @Override
    public void unmatched(Writer us, Guid reader) {
      CompletableFuture<Void> told = subscribed.remove(reader);
      if (told == null) return;
      // Whoever was told that it came is told that it has gone, and in this order.
      told.thenRun(() -> {
        String owner = names.remove(reader);
        if (owner != null) listener.disconnected(owner);
      });
    }

    @Override
    public void hindered(Writer us, EndpointInfo reader, String policy) {
      node.owners()
          .soon(reader.guid())
          .thenAccept(
              owner -> troubles.tell(owner + " asks for " + policy + " that is not offered here"));
    }
  }
}
