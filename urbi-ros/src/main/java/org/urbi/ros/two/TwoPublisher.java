package org.urbi.ros.two;

import java.nio.ByteBuffer;
import java.util.Map;
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
  private final TwoNode node;
  private final String topic;
  private final MessageCodec codec;
  private final Listener listener;
  private final Map<Guid, String> names = new ConcurrentHashMap<>();
  private final Writer writer;

  TwoPublisher(TwoNode node, String topic, MessageType type, Qos qos, Listener listener) {
    this.node = node;
    this.topic = topic;
    this.listener = listener;
    codec = MessageCodec.of(type);
    writer =
        node.writer(
            Mangling.topic(topic),
            Mangling.type(type.name()),
            TwoNode.qos(qos),
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
      String owner = node.ownerOf(reader.guid());
      names.put(reader.guid(), owner);
      listener.connected(owner);
    }

    @Override
    public void unmatched(Writer us, Guid reader) {
      String owner = names.remove(reader);
      if (owner != null) listener.disconnected(owner);
    }
  }
}
