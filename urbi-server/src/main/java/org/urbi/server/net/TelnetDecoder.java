package org.urbi.server.net;

import io.netty.buffer.ByteBuf;
import io.netty.buffer.Unpooled;
import io.netty.channel.ChannelHandlerContext;
import io.netty.channel.ChannelInboundHandlerAdapter;

/**
 * Removes the telnet commands (RFC 854) from the input of a client, and answers them: it refuses
 * all options. The interrupt key of a telnet client becomes a {@link TelnetInterrupt}. The payload
 * of a binary literal passes unchanged.
 */
final class TelnetDecoder extends ChannelInboundHandlerAdapter {
  private static final int SE = 240;
  private static final int BREAK = 243;
  private static final int INTERRUPT_PROCESS = 244;
  private static final int ARE_YOU_THERE = 246;
  private static final int SB = 250;
  private static final int WILL = 251;
  private static final int WONT = 252;
  private static final int DO = 253;
  private static final int DONT = 254;
  private static final int IAC = 255;
  private static final byte[] YES = {'[', 'y', 'e', 's', ']', '\r', '\n'};

  private enum State {
    DATA,
    CARRIAGE_RETURN,
    COMMAND,
    OPTION,
    SUBNEGOTIATION,
    SUBNEGOTIATION_COMMAND
  }

  private final BinaryLiteralDetector binary = new BinaryLiteralDetector();
  private State state = State.DATA;
  private final StringBuilder subnegotiation = new StringBuilder();
  private int command;

  @Override
  public void channelRead(ChannelHandlerContext context, Object message) {
    ByteBuf in = (ByteBuf) message;
    ByteBuf out = context.alloc().buffer(in.readableBytes());
    ByteBuf reply = Unpooled.EMPTY_BUFFER;
    try {
      while (in.isReadable()) {
        reply = take(context, in.readByte(), out, reply);
      }
    } finally {
      in.release();
    }
    if (reply.isReadable()) {
      context.writeAndFlush(reply);
    }
    if (out.isReadable()) {
      context.fireChannelRead(out);
    } else {
      out.release();
    }
  }

  private ByteBuf take(ChannelHandlerContext context, byte b, ByteBuf out, ByteBuf reply) {
    int code = b & 0xff;
    switch (state) {
      case DATA -> data(b, out);
      case CARRIAGE_RETURN -> {
        state = State.DATA;
        if (b != 0) {
          data(b, out);
        }
      }
      case COMMAND -> {
        command = code;
        state =
            switch (code) {
              case WILL, WONT, DO, DONT -> State.OPTION;
              case SB -> State.SUBNEGOTIATION;
              default -> State.DATA;
            };
        if (code == IAC) {
          pass(b, out);
        } else if (code == INTERRUPT_PROCESS || code == BREAK) {
          context.fireUserEventTriggered(TelnetInterrupt.INSTANCE);
        } else if (code == ARE_YOU_THERE) {
          return answer(context, reply, YES);
        }
      }
      case OPTION -> {
        state = State.DATA;
        if (command == DO) {
          return answer(context, reply, new byte[] {(byte) IAC, (byte) WONT, b});
        } else if (command == WILL) {
          return answer(context, reply, new byte[] {(byte) IAC, (byte) DONT, b});
        }
      }
      case SUBNEGOTIATION -> {
        if (code == IAC) {
          state = State.SUBNEGOTIATION_COMMAND;
        } else if (subnegotiation.length() < OperatorRequest.MAX_LENGTH) {
          subnegotiation.append((char) code);
        }
      }
      case SUBNEGOTIATION_COMMAND -> {
        state = code == SE ? State.DATA : State.SUBNEGOTIATION;
        if (code == SE) {
          subnegotiated(context);
        }
      }
    }
    return reply;
  }

  private void subnegotiated(ChannelHandlerContext context) {
    OperatorRequest request = OperatorRequest.parse(subnegotiation.toString());
    subnegotiation.setLength(0);
    if (request != null) {
      context.fireUserEventTriggered(request);
    }
  }

  private void data(byte b, ByteBuf out) {
    boolean payload = binary.inPayload();
    if (!payload && (b & 0xff) == IAC) {
      state = State.COMMAND;
      return;
    }
    pass(b, out);
    if (!payload && b == '\r') {
      state = State.CARRIAGE_RETURN;
    }
  }

  private void pass(byte b, ByteBuf out) {
    binary.accept(b);
    out.writeByte(b);
  }

  private static ByteBuf answer(ChannelHandlerContext context, ByteBuf reply, byte[] bytes) {
    ByteBuf to = reply.isReadable() ? reply : context.alloc().buffer();
    return to.writeBytes(bytes);
  }
}
