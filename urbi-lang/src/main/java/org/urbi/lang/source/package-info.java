/** Texts, and where things are in them. */
package org.urbi.lang.source;
