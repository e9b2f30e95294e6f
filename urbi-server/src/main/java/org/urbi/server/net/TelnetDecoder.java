package org.urbi.server.net;

import io.netty.buffer.ByteBuf;
import io.netty.channel.ChannelHandlerContext;
import io.netty.channel.ChannelInboundHandlerAdapter;
import java.util.function.Consumer;

/**
 * Removes the telnet commands (RFC 854) from the input of a client, and answers them: it refuses
 * all options. The interrupt key of a telnet client becomes a {@link TelnetInterrupt}. The payload
 * of a binary literal passes unchanged.
 *
 * <p>Answers go where the output of the client goes: whoever asks without end, and reads nothing,
 * is let go as for any other output.
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
  private static final String YES = "[yes]\r\n";

  private enum State {
    DATA,
    CARRIAGE_RETURN,
    COMMAND,
    OPTION,
    SUBNEGOTIATION,
    SUBNEGOTIATION_COMMAND
  }

  private final Consumer<String> answers;
  private final BinaryLiteralDetector binary = new BinaryLiteralDetector();
  private State state = State.DATA;
  private final StringBuilder subnegotiation = new StringBuilder();
  private int command;

  /**
   * @param answers takes what the client is answered, a byte in each character; on the network
   *     thread
   */
  TelnetDecoder(Consumer<String> answers) {
    this.answers = answers;
  }

  @Override
  public void channelRead(ChannelHandlerContext context, Object message) {
    ByteBuf in = (ByteBuf) message;
    ByteBuf out = context.alloc().buffer(in.readableBytes());
    StringBuilder answer = new StringBuilder(0);
    try {
      while (in.isReadable()) {
        take(context, in.readByte(), out, answer);
      }
    } finally {
      in.release();
    }
    if (!answer.isEmpty()) {
      answers.accept(answer.toString());
    }
    if (out.isReadable()) {
      context.fireChannelRead(out);
    } else {
      out.release();
    }
  }

  private void take(ChannelHandlerContext context, byte b, ByteBuf out, StringBuilder answer) {
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
          answer.append(YES);
        }
      }
      case OPTION -> {
        state = State.DATA;
        if (command == DO) {
          answer.append((char) IAC).append((char) WONT).append((char) code);
        } else if (command == WILL) {
          answer.append((char) IAC).append((char) DONT).append((char) code);
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
}
