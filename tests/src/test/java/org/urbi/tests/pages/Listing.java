package org.urbi.tests.pages;

import java.util.List;

/**
 * A listing of a page.
 *
 * @param line the line of the page on which it begins, from 1
 * @param kind what is done with it
 * @param detail what its marker says besides: the name of a module or file, or why it does not run
 * @param lines what it shows
 */
record Listing(int line, Kind kind, String detail, List<String> lines) {

  /** What is done with a listing; the marker before it names it. */
  enum Kind {
    /** A part of the page's one session with a kernel in virtual time. */
    SESSION("session", Detail.NONE),
    /** A session of its own. */
    SEPARATE_SESSION("separate session", Detail.NONE),
    /** A part of the page's session with a kernel that is a node of ROS 1, beside others. */
    ROS_1("ROS 1", Detail.NONE),
    /** A part of the page's session with a kernel that is a node of ROS 2, alone in its domain. */
    ROS_2("ROS 2", Detail.NONE),
    /** Commands, each with {@code $ } before it, and what they print. */
    TERMINAL("terminal", Detail.NONE),
    /** Commands that go on while the following listings run. */
    BACKGROUND("terminal in the background", Detail.NONE),
    /** A file that the following listings find in the working directory. */
    FILE("file", Detail.WANTED),
    /** A class of Java that the sessions load as a module, and that commands find as a file. */
    MODULE("module", Detail.WANTED),
    /** Java that is compiled: a class, or statements. */
    JAVA("java", Detail.NONE),
    /** C++ that is compiled. */
    CXX("c++", Detail.NONE),
    /** Java that is compiled and run; what it prints is the listing that follows. */
    PROGRAM("program", Detail.NONE),
    /** What the program before prints. */
    PRINTED("printed", Detail.NONE),
    /** A part of a file of the project, which is tested elsewhere. */
    EXCERPT("part of", Detail.WANTED),
    /** What cannot run here, for the reason given. */
    NOT_RUN("not run", Detail.WANTED);

    private final String word;
    private final Detail detail;

    Kind(String word, Detail detail) {
      this.word = word;
      this.detail = detail;
    }

    private enum Detail {
      NONE,
      WANTED
    }

    /** The kind that a marker names. */
    static Kind of(String word, String detail) {
      for (Kind kind : values()) {
        if (kind.word.equals(word) && (kind.detail == Detail.WANTED) == !detail.isBlank()) {
          return kind;
        }
      }
      throw new IllegalArgumentException(
          "no such marker: <!-- listing: "
              + word
              + (detail.isEmpty() ? "" : ": " + detail)
              + " -->");
    }
  }

  /** The text as it is fed to a compiler or written to a file. */
  String text() {
    return String.join("\n", lines) + "\n";
  }
}
