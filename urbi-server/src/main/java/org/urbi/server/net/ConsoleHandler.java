package org.urbi.server.net;

import io.netty.buffer.ByteBuf;
import io.netty.channel.ChannelFutureListener;
import io.netty.channel.ChannelHandlerContext;
import io.netty.channel.ChannelInboundHandlerAdapter;
import io.netty.channel.socket.ChannelInputShutdownEvent;
import java.io.IOException;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.Client;
import org.urbi.kernel.Connection;
import org.urbi.kernel.log.FailureLog;
import org.urbi.kernel.trust.Role;
import org.urbi.server.Trace;

/**
 * One client of the network console and its lobby.
 *
 * <p>Input goes to the lobby as it arrives. The handler stops reading while more than {@link
 * Limits#input} bytes wait for the kernel. When the client ends its stream, the lobby executes the
 * input that it has as far as that does not wait; when the client disconnects, the lobby ends.
 * {@link PeerProbe} tells the one from the other.
 */
final class ConsoleHandler extends ChannelInboundHandlerAdapter implements Client {
  /** The output limit of a process with UObjects, which receives images. */
  private static final long PROCESS_OUTPUT = 128L << 20;

  private final Function<Client, Connection> lobbies;
  private final Limits limits;
  private final TotalOutput totalOutput;
  private final Trace trace;
  private ChannelHandlerContext context;
  private ClientOutput output;
  private PeerProbe probe;
  private boolean inputEnded;
  private volatile @Nullable Connection connection;
  private volatile boolean over = true;

  ConsoleHandler(
      Function<Client, Connection> lobbies, Limits limits, TotalOutput totalOutput, Trace trace) {
    this.lobbies = lobbies;
    this.limits = limits;
    this.totalOutput = totalOutput;
    this.trace = trace;
  }

  @Override
  public void handlerAdded(ChannelHandlerContext context) {
    this.context = context;
    probe =
        new PeerProbe(
            context.channel(),
            () -> inputEnded || !context.channel().config().isAutoRead(),
            this::runningTurn);
    output =
        new ClientOutput(
            context.channel(),
            limits.output(),
            totalOutput,
            () -> trace.log("client does not read what it is sent, letting it go: " + name()));
  }

  private long runningTurn() {
    Connection lobby = connection;
    return lobby == null ? Connection.NO_TURN : lobby.runningTurn();
  }

  /** The connection to the lobby; null before there is one, and when it is over. */
  @Nullable Connection connection() {
    return connection;
  }

  @Override
  public void channelActive(ChannelHandlerContext context) {
    over = false;
    try {
      connection = lobbies.apply(this);
    } catch (RuntimeException | Error e) {
      over = true;
      throw e;
    }
    trace.debug("client connected: " + name());
  }

  @Override
  public void channelRead(ChannelHandlerContext context, Object message) {
    ByteBuf bytes = (ByteBuf) message;
    Connection lobby = over ? null : connection;
    try {
      if (lobby != null) {
        pass(bytes, lobby);
      }
    } finally {
      bytes.release();
    }
    if (lobby != null && lobby.pendingInput() > limits.input()) {
      context.channel().config().setAutoRead(false);
      probe.begin();
      inputConsumed();
    }
  }

  /**
   * Tries twice: all garbage has been collected for the first try, and whoever fills the heap may
   * have failed meanwhile. The thread of the network never waits: others want their answers.
   */
  private static void pass(ByteBuf bytes, Connection lobby) {
    try {
      lobby.send(bytes.toString(StandardCharsets.ISO_8859_1));
    } catch (OutOfMemoryError e) {
      lobby.send(bytes.toString(StandardCharsets.ISO_8859_1));
    }
  }

  @Override
  public void userEventTriggered(ChannelHandlerContext context, Object event) {
    Connection lobby = over ? null : connection;
    if (event instanceof OperatorRequest request && lobby != null) {
      answer(request, lobby);
    } else if (event instanceof Role role && lobby != null) {
      lobby.giveRole(role);
    } else if (event == TelnetInterrupt.INSTANCE && lobby != null) {
      lobby.interrupt();
    } else if (event == ChannelInputShutdownEvent.INSTANCE) {
      if (lobby == null) {
        context.close();
      } else {
        inputEnded = true;
        lobby.hangUp();
        probe.begin();
        NetworkThread.close(context.channel(), limits.secondsAfterEnd());
      }
    }
    context.fireUserEventTriggered(event);
  }

  /**
   * There may be thousands of them in what was just read, behind the one for which it is let go.
   */
  private void answer(OperatorRequest request, Connection lobby) {
    if (context.channel().isOpen()) {
      output("[00000000" + OperatorRequest.ANSWER + lobby.interrupt(request.lobby()) + "\n");
    }
  }

  @Override
  public void channelWritabilityChanged(ChannelHandlerContext context) {
    if (output != null && context.channel().isWritable()) {
      output.resume();
    }
    context.fireChannelWritabilityChanged();
  }

  @Override
  public void channelInactive(ChannelHandlerContext context) {
    trace.debug("client disconnected: " + name());
    if (output != null) {
      output.gone();
    }
    Connection lobby = connection;
    if (lobby != null) {
      lobby.close();
    }
  }

  @Override
  public void exceptionCaught(ChannelHandlerContext context, Throwable cause) {
    Connection lobby = connection;
    if (cause instanceof IOException) {
      trace.debug("client lost: " + name() + ": " + cause);
      context.close();
    } else if (lobby != null) {
      try {
        lobby.failed("the connection of " + name(), cause);
      } finally {
        if (cause instanceof OutOfMemoryError) {
          // A part of the input is lost, so what comes behind it must not be executed.
          context.close();
        }
      }
    } else {
      refuse(context, cause);
    }
  }

  /** Reports an internal error to a client that has no lobby, and disconnects it. */
  static void refuse(ChannelHandlerContext context, Throwable failure) {
    FailureLog.internal("the connection of " + context.channel().remoteAddress(), failure);
    context
        .writeAndFlush(ErrorLine.of("error", FailureLog.text(failure)))
        .addListener(ChannelFutureListener.CLOSE);
  }

  @Override
  public void output(String bytes) {
    output.add(bytes);
  }

  @Override
  public long unread() {
    return output.unsent();
  }

  @Override
  public String budget() {
    return limits.budget();
  }

  @Override
  public void inputConsumed() {
    Connection lobby = connection;
    if (lobby != null && lobby.pendingInput() <= limits.input() / 2) {
      var config = context.channel().config();
      if (!config.isAutoRead()) {
        config.setAutoRead(true);
      }
    }
  }

  @Override
  public void binary() {
    output.allow(PROCESS_OUTPUT);
    NetworkThread.execute(
        context.executor(),
        () -> {
          if (context.pipeline().get(TelnetDecoder.class) != null) {
            context.pipeline().remove(TelnetDecoder.class);
          }
        });
  }

  @Override
  public void closed() {
    over = true;
    output.finish();
  }

  /** The socket may remain open for some seconds; what the lobby has must not. */
  @Override
  public void forgotten() {
    connection = null;
  }

  @Override
  public Role role() {
    return TokenAuthenticator.role(context);
  }

  @Override
  public String remoteAddress() {
    return context.channel().remoteAddress() instanceof InetSocketAddress address
        ? address.getAddress().getHostAddress()
        : "";
  }

  private String name() {
    return String.valueOf(context.channel().remoteAddress());
  }
}
