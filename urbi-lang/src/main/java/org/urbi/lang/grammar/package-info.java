/** The ANTLR grammars of urbiscript, and what they need that a grammar cannot say. */
package org.urbi.lang.grammar;
