package org.urbi.ros.one;

import java.io.IOException;
import java.net.URI;
import java.nio.ByteBuffer;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import org.jspecify.annotations.Nullable;
import org.urbi.ros.codec.CodecException;
import org.urbi.ros.codec.MessageCodec;
import org.urbi.ros.graph.Failures;
import org.urbi.ros.graph.RosException;
import org.urbi.ros.graph.Subscription;
import org.urbi.ros.message.DefinitionException;
import org.urbi.ros.message.Dialect;
import org.urbi.ros.message.FullText;
import org.urbi.ros.message.MessageType;
import org.urbi.ros.message.TypeHash;
import org.urbi.ros.message.TypeName;
import urbi.UDictionary;

/** A topic that this node hears: a connection to each publisher, made again when it breaks. */
final class OneSubscription implements Subscription {
  /** Milliseconds between attempts to connect: at first, and at most. */
  private static final int FIRST_PAUSE = 100;

  private static final int LAST_PAUSE = 3000;

  private final OneNode node;
  private final String topic;
  private final @Nullable MessageType wanted;
  private final Subscription.Listener listener;
  private final Map<URI, Link> links = new ConcurrentHashMap<>();
  private boolean closed;
  private @Nullable String typed;

  OneSubscription(
      OneNode node, String topic, @Nullable MessageType wanted, Subscription.Listener listener) {
    this.node = node;
    this.topic = topic;
    this.wanted = wanted;
    this.listener = listener;
  }

  @Override
  public String topic() {
    return topic;
  }

  /** The type for the master: a star if any will do. */
  String typeName() {
    return wanted == null ? TypeHash.ANY_MD5 : wanted.name().in(Dialect.ROS_1);
  }

  @Override
  public int publishers() {
    return (int) links.values().stream().filter(link -> link.connected).count();
  }

  /** How many publishers it knows of, connected or not. */
  int known() {
    return links.size();
  }

  /** These are the publishers now. */
  synchronized void update(List<URI> publishers) {
    if (closed) {
      return;
    }
    links
        .entrySet()
        .removeIf(link -> {
          boolean gone = !publishers.contains(link.getKey());
          if (gone) {
            link.getValue().close();
          }
          return gone;
        });
    for (URI uri : publishers) {
      links.computeIfAbsent(uri, Link::new);
    }
  }

  @Override
  public synchronized void close() {
    closed = true;
    node.remove(this);
    links.values().forEach(Link::close);
    links.clear();
  }

  /** The type of a connection: one who takes any is told whenever it is another one. */
  private MessageType typeOf(Map<String, String> header) {
    String md5 = header.getOrDefault(ConnectionHeader.MD5, "");
    if (wanted != null) {
      if (!md5.equals(TypeHash.md5(wanted))) {
        throw new RosException(
            topic + " has another version of " + typeName() + " (MD5 sum " + md5 + ")");
      }
      return told(md5, wanted);
    }
    TypeName name =
        TypeName.parse(header.getOrDefault(ConnectionHeader.TYPE, ""), TypeName.Kind.MESSAGE);
    String text = header.getOrDefault(ConnectionHeader.DEFINITION, "");
    MessageType type;
    try {
      type = FullText.read(name, text);
    } catch (DefinitionException e) {
      type = node.definitions().message(name);
    }
    if (!TypeHash.md5(type).equals(md5)) {
      type = node.definitions().message(name);
    }
    if (!TypeHash.md5(type).equals(md5)) {
      throw new RosException(
          topic
              + " is of a version of "
              + name.in(Dialect.ROS_1)
              + " (MD5 sum "
              + md5
              + ") of which there is no definition");
    }
    return told(md5, type);
  }

  private synchronized MessageType told(String md5, MessageType type) {
    if (!md5.equals(typed)) {
      typed = md5;
      listener.typed(type);
    }
    return type;
  }

  /** The connection to one publisher. */
  private final class Link {
    private final URI publisher;
    private final Thread thread;
    private volatile boolean ended;
    private volatile boolean connected;
    private @Nullable TcpRosConnection connection;
    private String complaint = "";

    Link(URI publisher) {
      this.publisher = publisher;
      this.thread = Threads.start("subscriber", this::run);
    }

    private void run() throws InterruptedException {
      int pause = FIRST_PAUSE;
      while (!ended) {
        try (TcpRosConnection open = connect()) {
          pause = FIRST_PAUSE;
          hear(open, MessageCodec.of(shakeHands(open)));
        } catch (IOException | RuntimeException | Error e) {
          complain(Failures.cause(e));
        }
        connected = false;
        if (!ended) {
          Thread.sleep(pause);
          pause = Math.min(LAST_PAUSE, 2 * pause);
        }
      }
    }

    /** Says what is wrong: once, as long as it is the same. That a peer has gone is no failure. */
    private void complain(Throwable failure) {
      String reason = Failures.text(failure);
      boolean isOfTheNetwork =
          failure instanceof IOException
              || failure instanceof RosException && failure.getCause() != null;
      if (!ended && !isOfTheNetwork && !reason.equals(complaint)) {
        complaint = reason;
        listener.failed(Failures.told("a subscription of " + topic, failure));
      }
    }

    private TcpRosConnection connect() throws IOException {
      List<?> protocol =
          node.api(publisher)
              .call(value -> (List<?>) value, "requestTopic", topic, List.of(List.of("TCPROS")))
              .join();
      if (protocol.size() < 3
          || !(protocol.get(1) instanceof String host)
          || !(protocol.get(2) instanceof Integer port)) {
        throw new IOException("no TCPROS from " + publisher);
      }
      TcpRosConnection open = TcpRosConnection.to(host, port);
      synchronized (this) {
        connection = open;
        if (ended) {
          open.close();
        }
      }
      return open;
    }

    private MessageType shakeHands(TcpRosConnection open) throws IOException {
      Map<String, String> header = new LinkedHashMap<>();
      header.put(ConnectionHeader.CALLER, node.name());
      header.put(ConnectionHeader.TOPIC, topic);
      header.put(ConnectionHeader.TYPE, typeName());
      header.put(ConnectionHeader.MD5, wanted == null ? TypeHash.ANY_MD5 : TypeHash.md5(wanted));
      header.put(ConnectionHeader.NO_DELAY, "1");
      open.sendHeader(header);
      Map<String, String> answer = open.readHeader();
      String error = answer.get(ConnectionHeader.ERROR);
      if (error != null) {
        throw new RosException(error);
      }
      return typeOf(answer);
    }

    private void hear(TcpRosConnection open, MessageCodec codec) throws IOException {
      connected = true;
      complaint = "";
      while (!ended) {
        ByteBuffer bytes = open.read();
        synchronized (OneSubscription.this.listener) {
          if (ended || listener.takes(bytes.slice())) {
            continue;
          }
        }
        UDictionary message;
        try {
          message = codec.decode(bytes);
        } catch (CodecException e) {
          complain(e);
          continue;
        }
        synchronized (OneSubscription.this.listener) {
          if (!ended) {
            listener.received(message);
          }
        }
      }
    }

    synchronized void close() {
      ended = true;
      if (connection != null) {
        connection.close();
      }
      thread.interrupt();
    }
  }
}
