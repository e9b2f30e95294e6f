package org.urbi.ros.one;

import java.io.EOFException;
import java.io.IOException;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.nio.ByteOrder;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.Lock;
import java.util.concurrent.locks.ReentrantLock;
import org.jspecify.annotations.Nullable;
import org.urbi.ros.codec.MessageCodec;
import org.urbi.ros.graph.Publisher;
import org.urbi.ros.graph.Qos;
import org.urbi.ros.graph.RosException;
import org.urbi.ros.message.Dialect;
import org.urbi.ros.message.Field;
import org.urbi.ros.message.FieldType;
import org.urbi.ros.message.FullText;
import org.urbi.ros.message.MessageType;
import org.urbi.ros.message.TypeHash;
import org.urbi.ros.message.TypeName;
import urbi.UDictionary;

/** A topic on which this node says something: who listens, and what each has still to get. */
final class Publication {
  /** So many wait for a subscriber where no number is wanted. */
  private static final int MAX_WAITING = 1000;

  /** Bytes that are no longer waiting, but being sent. */
  private static final int BATCH = 1 << 16;

  private static final FieldType HEADER =
      new FieldType.Nested(TypeName.message("std_msgs", "Header"));

  private static final VarHandle INTEGER =
      MethodHandles.byteArrayViewVarHandle(int[].class, ByteOrder.LITTLE_ENDIAN);

  private final OneNode node;
  private final String topic;
  private final MessageCodec codec;
  private final String md5;
  private final Qos qos;
  private final List<Handle> handles = new CopyOnWriteArrayList<>();
  private final List<Listener> listeners = new CopyOnWriteArrayList<>();
  private byte @Nullable [] latched;

  /** Whether a message begins with a header, and so with its number, as in rospy and roscpp. */
  private final boolean numbered;

  private int number;

  Publication(OneNode node, String topic, MessageType type, Qos qos) {
    this.node = node;
    this.topic = topic;
    this.codec = MessageCodec.of(type);
    this.md5 = TypeHash.md5(type);
    this.qos = qos;
    List<Field> fields = type.definition().fields();
    this.numbered = !fields.isEmpty() && fields.getFirst().type().equals(HEADER);
  }

  /** One who publishes here: there may be several in this node. */
  private final class Handle implements Publisher {
    private final Publisher.Listener told;

    Handle(Publisher.Listener told) {
      this.told = told;
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
      if (!handles.contains(this)) {
        throw new RosException(topic + " is no longer advertised");
      }
      send(codec.encode(message));
    }

    @Override
    public int subscribers() {
      return listeners.size();
    }

    @Override
    public void close() {
      if (handles.remove(this) && handles.isEmpty()) {
        node.remove(Publication.this);
        closeAll();
      }
    }
  }

  /** A node that has subscribed. */
  private final class Listener {
    private final String name;
    private final TcpRosConnection connection;
    private final Deque<byte[]> waiting = new ArrayDeque<>();

    /** Not a monitor: threads of the JDK that wait for one are woken by way of another thread. */
    private final Lock lock = new ReentrantLock();

    private final Condition changed = lock.newCondition();
    private boolean isIdle;
    private boolean closed;

    Listener(String name, TcpRosConnection connection) {
      this.name = name;
      this.connection = connection;
    }

    void offer(byte[] message) {
      int most = qos.depth() == 0 ? MAX_WAITING : qos.depth();
      lock.lock();
      try {
        while (waiting.size() >= most) {
          waiting.removeFirst();
        }
        waiting.addLast(message);
        if (isIdle) {
          isIdle = false;
          changed.signal();
        }
      } finally {
        lock.unlock();
      }
    }

    /**
     * Waits for something to send.
     *
     * @param batch gets as much of it as is written at once; nothing when that is all
     */
    private void take(List<byte[]> batch) throws InterruptedException {
      lock.lock();
      try {
        while (waiting.isEmpty() && !closed) {
          isIdle = true;
          changed.await();
        }
        int size = 0;
        while (!waiting.isEmpty() && !closed && size < BATCH) {
          byte[] message = waiting.removeFirst();
          size += message.length;
          batch.add(message);
        }
      } finally {
        lock.unlock();
      }
    }

    void write() throws IOException, InterruptedException {
      try {
        List<byte[]> batch = new ArrayList<>();
        for (take(batch); !batch.isEmpty(); take(batch)) {
          for (byte[] message : batch) {
            connection.write(message);
          }
          connection.flush();
          batch.clear();
        }
      } finally {
        connection.close();
      }
    }

    void close() {
      lock.lock();
      try {
        closed = true;
        changed.signal();
      } finally {
        lock.unlock();
      }
      connection.close();
    }
  }

  String topic() {
    return topic;
  }

  MessageType type() {
    return codec.type();
  }

  String typeName() {
    return type().name().in(Dialect.ROS_1);
  }

  /**
   * One more who publishes here.
   *
   * @throws RosException if it is with another type
   */
  Publisher add(MessageType type, Publisher.Listener told) {
    if (!TypeHash.md5(type).equals(md5)) {
      throw new RosException(
          topic
              + " is advertised as "
              + typeName()
              + " by this node already, not as "
              + type.name().in(Dialect.ROS_1));
    }
    Handle handle = new Handle(told);
    handles.add(handle);
    for (Listener each : listeners) {
      told.connected(each.name);
    }
    return handle;
  }

  private void send(byte[] message) {
    synchronized (this) {
      if (numbered) {
        INTEGER.set(message, 0, ++number);
      }
      if (qos.keptForLate()) {
        latched = message;
      }
    }
    for (Listener each : listeners) {
      each.offer(message);
    }
  }

  /** Serves a subscriber until it goes. */
  void serve(Map<String, String> header, TcpRosConnection connection) throws IOException {
    String caller = header.getOrDefault(ConnectionHeader.CALLER, "?");
    String theirs = header.getOrDefault(ConnectionHeader.MD5, "");
    String theirType = header.getOrDefault(ConnectionHeader.TYPE, "");
    if (!theirs.equals(TypeHash.ANY_MD5) && !theirs.equals(md5)) {
      connection.sendHeader(
          Map.of(
              ConnectionHeader.ERROR,
              "Client ["
                  + caller
                  + "] wants topic "
                  + topic
                  + " to have datatype/md5sum ["
                  + theirType
                  + "/"
                  + theirs
                  + "], but our version has ["
                  + typeName()
                  + "/"
                  + md5
                  + "]. Dropping connection."));
      return;
    }
    Listener listener = new Listener(caller, connection);
    synchronized (this) {
      if (latched != null) {
        listener.offer(latched);
      }
      listeners.add(listener);
    }
    try {
      // Whoever reads the answer misses nothing of what is published from then on.
      connection.sendHeader(header());
      if (handles.isEmpty()) {
        // Unadvertised in the meantime.
        listener.close();
      }
      handles.forEach(each -> each.told.connected(caller));
      Threads.start("publisher", listener::write);
      // A subscriber says nothing more: when there is something to read, it has gone.
      connection.readByte();
    } catch (EOFException e) {
      // The usual end.
      return;
    } finally {
      listeners.remove(listener);
      listener.close();
      handles.forEach(each -> each.told.disconnected(caller));
    }
  }

  private Map<String, String> header() {
    Map<String, String> header = new LinkedHashMap<>();
    header.put(ConnectionHeader.CALLER, node.name());
    header.put(ConnectionHeader.TOPIC, topic);
    header.put(ConnectionHeader.TYPE, typeName());
    header.put(ConnectionHeader.MD5, md5);
    header.put(ConnectionHeader.DEFINITION, FullText.write(type()));
    header.put(ConnectionHeader.LATCHING, qos.keptForLate() ? "1" : "0");
    return header;
  }

  void closeAll() {
    handles.clear();
    listeners.forEach(Listener::close);
  }
}
