// node_modules/preact/dist/preact.mjs
var n$1;
var t$3;
var r$2;
var u$3;
var i$2;
var f$3;
var o$3;
var e$2;
var l$2;
var c$2;
var a$3;
var h$3 = Symbol.for("pv");
var p$3 = {};
var y$3 = [];
var v$2 = /^m(i|n|o|s|text|space)$/;
var w$3 = Array.isArray;
var d$2 = y$3.slice;
var _$2 = Object.assign;
function g$3(n) {
	n && n.parentNode && n.remove();
}
function k$2(n, t, r) {
	var u, i, f, o = {}, e = arguments.length;
	for (f in t) "key" == f ? u = t[f] : "ref" == f && "function" != typeof n ? i = t[f] : o[f] = t[f];
	return e > 2 && (o.children = e > 3 ? d$2.call(arguments, 2) : r), m$3(n, o, u, i, null);
}
function m$3(r, u, i, f, o) {
	var e = {
		type: r,
		props: u,
		key: i,
		ref: f,
		__k: null,
		__: null,
		__b: 0,
		__e: null,
		__c: null,
		constructor: h$3,
		__v: o || ++t$3,
		__i: -1,
		__u: 0
	};
	return !o && n$1.vnode && n$1.vnode(e), e;
}
function $(n) {
	return n.children;
}
function x$1(n, t) {
	this.props = n, this.context = t, this.__g = 0;
}
function S$1(n, t) {
	if (null == t) return n.__ && S$1(n.__, n.__i + 1);
	for (var r; t < n.__k.length; t++) if ((r = n.__k[t]) && r.__e) return r.__e;
	return "function" != typeof n.type || n.props.__P ? null : S$1(n);
}
function C$1(t) {
	var r, u = t.__v, i = u.__e, f = [], o = [], e = t.__P;
	e && ((r = _$2({ constructor: h$3 }, u)).__v = u.__v + 1, n$1.vnode && n$1.vnode(r), z$1(e, r, u, t.__n, e.namespaceURI, 32 & u.__u ? [i] : null, f, i || S$1(u), 32 & u.__u, o), r.__v = u.__v, r.__.__k[r.__i] = r, E$1(f, r, o), u.__ = u.__e = null, r.__e != i && j$1(r));
}
function j$1(n) {
	if ((n = n.__) && n.__c && !n.props.__P) return n.__e = null, n.__k.some(function(t) {
		return t && (n.__e = t.__e);
	}), j$1(n);
}
function L(t) {
	(8 & t.__g || (t.__g |= 8, u$3.push(t), f$3++)) && i$2 == n$1.debounceRendering || ((i$2 = n$1.debounceRendering) || queueMicrotask)(H);
}
function H() {
	try {
		for (var n, t = 1; u$3.length;) u$3.length > t && u$3.sort(o$3), n = u$3.shift(), t = u$3.length, 8 & n.__g && C$1(n);
	} finally {
		(f$3 = u$3.length) && (i$2 || queueMicrotask)(H);
	}
}
function I(n, t, r, u, i, f, o, e, l, c, a) {
	var s, h, v, w, d, _, g = u.__k || y$3, k = t.length;
	for (l = q(r, t, g, l, k), s = 0; s < k; s++) null != (v = r.__k[s]) && (h = ~v.__i && g[v.__i] || p$3, v.__i = s, _ = z$1(n, v, h, i, f, o, e, l, c, a), w = v.__e, (h.ref != v.ref || 8 & h.__u) && (h.ref && G(h.ref, null, v, h), v.ref && a.push(v.ref, v.__c || w, v)), d = d || w, 4 & v.__u ? (l = A$2(v, l, n, !h.__v), h.__e && (h.__e = null)) : "function" == typeof v.type && void 0 !== _ ? l = _ : w && (l = w.nextSibling), v.__u &= -21);
	return r.__e = d, l;
}
function q(n, t, r, u, i) {
	var f, o, e, l, c, a, s, p, y, v = r.length, d = v, _ = 0, g = 0, k = n.__k = Array(i);
	for (f = 0; f < i; f++) null != (o = t[f]) && "boolean" != typeof o && "function" != typeof o ? ("object" != typeof o || o.constructor === String ? o = k[f] = m$3(null, o) : w$3(o) ? o = k[f] = m$3($, { children: o }) : o.constructor === h$3 && o.__b ? o = k[f] = m$3(o.type, o.props, o.key, o.ref, o.__v) : k[f] = o, l = f + _, o.__ = n, o.__b = n.__b + 1, e = null, ~(c = o.__i = P(o, r, l, d)) && (d--, (e = r[c]) && (e.__u |= 2)), e && e.__v ? (o.__u |= 16, c == l - 1 ? _-- : c == l + 1 ? _++ : c != l && (c > l ? _-- : _++, g = 1)) : (~c || (i > v ? _-- : i < v && _++), "function" != typeof o.type && (o.__u |= 4))) : k[f] = null;
	if (g) {
		for (a = [], s = [], f = 0; f < i; f++) if ((o = k[f]) && 16 & o.__u) {
			for (_ = 0, p = a.length; _ < p;) a[y = _ + p >> 1] < o.__i ? _ = y + 1 : p = y;
			a[_] = o.__i, s[f] = _ + 1;
		}
		for (_ = a.length; f--;) s[f] && (s[f] == _ ? _-- : k[f].__u |= 4);
	}
	if (d) for (f = 0; f < v; f++) !(e = r[f]) || 2 & e.__u || (e.__e == u && (u = S$1(e)), J(e, e));
	return u;
}
function A$2(n, t, r, u) {
	var i, f, o, e;
	if ("function" == typeof n.type) {
		if (n.props.__P) return t;
		if (i = n.__k) for (f = 0; f < i.length; f++) i[f] && (i[f].__ = n, t = A$2(i[f], t, r, !1));
		return t;
	}
	for (t && !t.parentNode && (t = S$1(n)) && !t.parentNode && (t = null), o = n.__e, e = t; e && 8 == e.nodeType;) e = e.nextSibling;
	for (o != e && (!u && r.moveBefore && o.parentNode ? r.moveBefore(o, t) : r.insertBefore(o, t || null)), t = o; (t = t && t.nextSibling) && 8 == t.nodeType && !t.data.startsWith("$s"););
	return t;
}
function P(n, t, r, u) {
	var i, f = n.key, o = n.type, e = t[r], l = e && !(2 & e.__u);
	if (null === e && null == f || l && f == e.key && o == e.type) return r;
	if (u > (l ? 1 : 0)) {
		for (i = r - 1; i >= 0; i--) if ((e = t[i]) && !(2 & e.__u) && f == e.key && o == e.type) return i;
		for (i = r + 1; i < t.length; i++) if ((e = t[i]) && !(2 & e.__u) && f == e.key && o == e.type) return i;
	}
	return -1;
}
function T$1(n, t, r) {
	r ??= "", "-" == t[0] ? n.setProperty(t, r) : n[t] = r;
}
function N(n, t, r, u, i) {
	var f, o;
	if ("style" == t) if ("string" == typeof r) n.style.cssText = r;
	else {
		if ("string" == typeof u && (n.style.cssText = u = ""), u) for (t in u) r && t in r || T$1(n.style, t);
		if (r) for (t in r) u && r[t] == u[t] || T$1(n.style, t, r[t]);
	}
	else if ("o" == t[0] && "n" == t[1]) "function" != typeof r && (r = null), "function" != typeof u && (u = null), (n.__e || (n.__e = {}))[t] = r, r && u || (o = a$3[t] || (a$3[t] = V(t)), (n.__a || (n.__a = {}))[t] = c$2, f = t != (t = t.replace(l$2, "$1")), (t = t.slice(2))[0] < "a" && (t = t.toLowerCase()), r ? n.addEventListener(t, o, f) : n.removeEventListener(t, o, f));
	else {
		if ("http://www.w3.org/2000/svg" == i) t = t.replace(/xlink(H|:h)/, "h").replace(/sName$/, "s");
		else if ("width" != t && "height" != t && "href" != t && "list" != t && "form" != t && "tabIndex" != t && "download" != t && "rowSpan" != t && "colSpan" != t && "role" != t && "popover" != t && t in n) try {
			n[t] = null == r ? "" : r;
			return;
		} catch (n) {}
		if ("function" == typeof r) return;
		null == r || !1 === r && "-" != t[4] ? n.removeAttribute(t) : n.setAttribute(t, "popover" == t && 1 == r ? "" : r);
	}
}
function V(t) {
	return function(r) {
		var u = this.__e;
		if (u) {
			if (u = u[t], null == r[e$2]) r[e$2] = c$2++;
			else if (r[e$2] < this.__a[t]) return;
			return u(n$1.event ? n$1.event(r) : r);
		}
	};
}
function z$1(t, r, u, i, f, o, e, l, c, a) {
	var s, p, v, d, k, b, m, M, C, j, L, H, q, A, O, P, T, N, V = r.type;
	if (r.constructor !== h$3) return null;
	128 & u.__u && (c = 32 & u.__u, s = u.__c.__z) && (r.__u |= c, p = o = [], 8 == s.nodeType ? l = B$1(s, o) : o.push(s), l = o[0] || l), (s = n$1.__b) && s(r);
	n: if ("function" == typeof V) {
		v = e.length;
		try {
			if (M = r.props, C = (s = V.prototype) && s.render, j = (s = V.contextType) && i[s.__c], L = s ? j ? j.props.value : s.__ : i, (d = u.__c) ? (r.__c = d, 2 & d.__g && (d.__g |= 1)) : (C ? r.__c = d = new V(M, L) : (r.__c = d = new x$1(M, L), d.constructor = V, d.render = K), j && j.sub(d), d.state || (d.state = {}), d.__n = i, d.__g |= 8, d.__h = [], d.__k = []), C && (d.__s || (d.__s = d.state), V.getDerivedStateFromProps && (d.__s == d.state && (d.__s = _$2({}, d.__s)), _$2(d.__s, V.getDerivedStateFromProps(M, d.__s)))), k = d.props, b = d.state, d.__v = r, u.__c) {
				if (M !== k && C && !V.getDerivedStateFromProps && d.componentWillReceiveProps && d.componentWillReceiveProps(M, L), r.__v == u.__v && !(8 & d.__g) || !(4 & d.__g) && d.shouldComponentUpdate && !1 === d.shouldComponentUpdate(M, d.__s, L)) {
					r.__v != u.__v && (d.props = M, d.state = d.__s, d.__g &= -9), r.__e = u.__e, r.__k = u.__k, r.__k.some(function(n) {
						n && (n.__ = r);
					}), y$3.push.apply(d.__h, d.__k), d.__k = [], d.__h.length && e.push(d), l = S$1(u);
					break n;
				}
				d.componentWillUpdate && d.componentWillUpdate(M, d.__s, L), C && d.componentDidUpdate && d.__h.push(function() {
					d.componentDidUpdate(k, b, m);
				});
			} else C && !V.getDerivedStateFromProps && d.componentWillMount && d.componentWillMount(), C && d.componentDidMount && d.__h.push(d.componentDidMount);
			d.context = L, d.props = M, d.__P = t, d.__g &= -5, H = n$1.__r, q = C ? 25 : 0;
			do
				d.__g &= -9, H && H(r), s = d.render(d.props, d.state = d.__s, d.context);
			while (8 & d.__g && ++q < 25);
			C && (y$3.push.apply(d.__h, d.__k), d.__k = []), d.state = d.__s, d.getChildContext && (i = _$2({}, i, d.getChildContext())), C && u.__c && d.getSnapshotBeforeUpdate && (m = d.getSnapshotBeforeUpdate(k, b)), A = s && s.type === $ && null == s.key ? s.props.children : s, M.__P && (s = l, f = (t = M.__P).namespaceURI, c = o = null, u.props && u.props.__P != t && (u.__k.some(function(n) {
				n && J(n, n);
			}), u.__k = null), l = u.__k ? S$1(u, 0) : null), l = I(t, w$3(A) ? A : [A], r, u, i, f, o, e, l, c, a), M.__P && (r.__e = null, l = s), r.__u &= -161, p && p.some(g$3), d.__h.length && e.push(d), 1 & d.__g && (d.__g &= -4);
		} catch (t) {
			if (e.length = v, r.__v = null, c || o) if (t && t.then) {
				if (r.__u |= 128 | c, o) {
					for (~(T = o.indexOf(l || void 0)) || (T = o.length); (N = o[T - 1]) && 8 == N.nodeType;) T--;
					for (; T < o.length; T++) if (N = o[T]) if (o[T] = null, O) {
						if (N == P) break;
					} else {
						if (8 != N.nodeType) break;
						N.data.startsWith("$s") && (P = B$1(O = N));
					}
				}
				if (!O) {
					for (; l && 8 == l.nodeType && l.nextSibling;) l = l.nextSibling;
					O = l;
				}
				(s = B$1(O = r.__c.__z || (r.__c.__z = O))) ? (r.__e = O, l = s) : r.__e = l, l = l && l.nextSibling;
			} else o && o.some(g$3);
			else r.__e = u.__e;
			r.__k || (r.__k = u.__k || []), t && t.then || D$1(r), n$1.__e(t, r, u);
		}
	} else l = r.__e = F$1(u.__e, r, u, i, f, o, e, c, a, t);
	return (s = n$1.diffed) && s(r), l;
}
function B$1(n, t) {
	if (n && 8 == n.nodeType && n.data.startsWith("$s")) for (var r = 1; n = n.nextSibling;) {
		if (8 == n.nodeType) {
			if (n.data.startsWith("$s")) r++;
			else if (n.data.startsWith("/$s") && !--r) return n;
		}
		t && t.push(n);
	}
}
function D$1(n) {
	n && (n.__c && (n.__c.__g |= 4), n.__k && n.__k.some(D$1));
}
function E$1(t, r, u) {
	for (var i = 0; i < u.length;) G(u[i++], u[i++], u[i++]);
	n$1.__c && n$1.__c(r, t), t.some(function(r) {
		try {
			t = r.__h, r.__h = [], t.some(function(n) {
				n.call(r);
			});
		} catch (t) {
			n$1.__e(t, r.__v);
		}
	});
}
function F$1(t, r, u, i, f, o, e, l, c, a) {
	var s, h, y, _, k, b, m, M, $ = u.props || p$3, x = r.props, C = r.type;
	if ("svg" == C ? f = "http://www.w3.org/2000/svg" : "math" == C ? f = "http://www.w3.org/1998/Math/MathML" : f || (f = "http://www.w3.org/1999/xhtml"), o) {
		for (s = 0; s < o.length; s++) if ((k = o[s]) && (C ? k.localName == C : 3 == k.nodeType)) {
			t = k, o[s] = null;
			break;
		}
	}
	if (!t) {
		if (M = a.ownerDocument || document, !C) return M.createTextNode(x);
		t = M.createElementNS(f, C, x.is ? x : a), l && (n$1.__m && n$1.__m(r, o), l = !1), o = null;
	}
	if (C) {
		if (a = "template" == C && t.content || t, o = "textarea" == C && null != x.defaultValue ? null : o && d$2.call(a.childNodes), !l && o) for ($ = {}, s = 0; s < t.attributes.length; s++) $[(k = t.attributes[s]).name] = k.value;
		for (s in $) k = $[s], "dangerouslySetInnerHTML" == s ? y = k : "children" == s || s in x || "value" == s && "defaultValue" in x || "checked" == s && "defaultChecked" in x || N(t, s, null, k, f);
		for (s in x) k = x[s], "children" == s ? _ = k : "dangerouslySetInnerHTML" == s ? h = k : "value" == s ? b = k : "checked" == s ? m = k : l && "function" != typeof k || $[s] === k || N(t, s, k, $[s], f);
		h ? (l || y && (h.__html == y.__html || h.__html == t.innerHTML) || (t.innerHTML = h.__html), r.__k = []) : (y && (t.textContent = ""), ("foreignObject" == C || "http://www.w3.org/1998/Math/MathML" == f && v$2.test(C)) && (f = "http://www.w3.org/1999/xhtml"), I(a, w$3(_) ? _ : [_], r, u, i, f, o, e, o ? o[0] : u.__k && S$1(u, 0), l, c), o && o.some(g$3)), l && "textarea" != C || (s = "value", "progress" == C && null == b ? t.removeAttribute(s) : null == b || b === t[s] && ("progress" != C || b) || N(t, s, b, $[s], f), s = "checked", null != m && m != t[s] && N(t, s, m, $[s], f));
	} else $ === x || l && t.data == x || (t.data = x);
	return t;
}
function G(t, r, u, i) {
	try {
		"function" == typeof t ? r ? r.__x = t(r) || 1 : i && (i = i.__c || i.__e) && (r = i.__x) && (i.__x = null, "function" == typeof r ? r() : t(null)) : t.current = r;
	} catch (t) {
		n$1.__e(t, u);
	}
}
function J(t, r, u) {
	var i, f, o, e;
	if (n$1.unmount && n$1.unmount(t), !(i = t.ref) || i.current && i.current != t.__e || G(i, null, r, t), i = t.__c) {
		if (i.componentWillUnmount) try {
			i.componentWillUnmount();
		} catch (t) {
			n$1.__e(t, r);
		}
		i.__P = i.__n = null;
	}
	if (i = t.__k) for (e = 0; e < i.length; e++) i[e] && J(i[e], r, "function" != typeof t.type || u && !t.props.__P);
	!u && (i = t.__c) && (i = i.__z) && (f = B$1(i, o = [])) && (i == t.__e && o.some(g$3), g$3(f), g$3(i)), u || g$3(t.__e), t.__e = t.__c = t.__ = null;
}
function K(n, t, r) {
	return this.constructor(n, r);
}
function Q(t, r) {
	var u, i, f, o;
	n$1.__ && n$1.__(t, r), 9 == r.nodeType && (r = r.documentElement), i = (u = t && 32 & t.__u) ? null : r.__k, r.__k = m$3($, { children: [t] }), f = [], o = [], z$1(r, r.__k, i || p$3, p$3, r.namespaceURI, i ? null : r.firstChild ? d$2.call(r.childNodes) : null, f, i ? i.__e : r.firstChild, u, o), E$1(f, r.__k, o), r.__k.props.children = null;
}
n$1 = { __e: function(n, t, r, u) {
	for (var i, o, e; t = t.__;) if ((i = t.__c) && !(1 & i.__g)) {
		i.__g |= 4;
		try {
			if ((e = (o = i.constructor) && o.getDerivedStateFromError) && i.setState(o.getDerivedStateFromError(n)), i.componentDidCatch && (i.componentDidCatch(n, u || {}), e = 1), e && 8 & i.__g) return void (i.__g |= 2);
		} catch (t) {
			n = t;
		}
	}
	throw f$3 = 0, n;
} }, t$3 = 0, r$2 = function(n) {
	return null != n && n.constructor === h$3;
}, x$1.prototype.setState = function(n, t) {
	var r = this.__s;
	r && r != this.state || (r = this.__s = _$2({}, this.state)), "function" == typeof n && (n = n(_$2({}, r), this.props)), n && (_$2(r, n), this.__v && (t && this.__k.push(t), L(this)));
}, x$1.prototype.forceUpdate = function(n) {
	this.__v && (this.__g |= 4, n && this.__h.push(n), L(this));
}, x$1.prototype.render = $, u$3 = [], f$3 = 0, o$3 = function(n, t) {
	return n.__v.__b - t.__v.__b;
}, e$2 = Symbol(), l$2 = /(PointerCapture)$|Capture$/i, c$2 = 0, a$3 = {};
// node_modules/preact/hooks/dist/hooks.mjs
var t$2;
var r$1;
var u$2;
var i$1;
var o$2 = Object.is;
var f$2 = 0;
var c$1 = [];
var e$1 = [];
var a$2 = n$1;
var v$1 = a$2.__b;
var l$1 = a$2.__r;
var m$2 = a$2.diffed;
var h$2 = a$2.__c;
var s$1 = a$2.unmount;
var p$2 = a$2.__;
function y$2(n, t) {
	a$2.__h && a$2.__h(r$1, n, f$2 || t), f$2 = 0;
	var u = r$1.__H || (r$1.__H = {
		__: [],
		__h: []
	});
	return n >= u.__.length && u.__.push({}), u.__[n];
}
function A$1(n, u) {
	var i = y$2(t$2++, 3);
	!a$2.__s && E(i.__H, u) && (i.__P = !0, i.__ = n, i.u = u, r$1.__H.__h.push(i));
}
function T(n) {
	return f$2 = 5, w$2(function() {
		return { current: n };
	}, []);
}
function w$2(n, r) {
	var u = y$2(t$2++, 7);
	return E(u.__H, r) && (u.__ = n(), u.__H = r), u.__;
}
function g$2() {
	var n;
	do {
		for (; n = e$1.shift();) try {
			C(n);
		} catch (t) {
			a$2.__e(t, { __: (n = n.__P) && n.__v });
		}
		for (; n = c$1.shift();) {
			var t = n.__H;
			if (n.__P && t) try {
				t.__h.some(C), t.__h.some(D), t.__h = [];
			} catch (r) {
				t.__h = [], a$2.__e(r, n.__v);
			}
		}
	} while (e$1.length);
}
a$2.__b = function(n) {
	r$1 = null, v$1 && v$1(n);
}, a$2.__ = function(n, t) {
	n && t.__k && t.__k.__m && (n.__m = t.__k.__m), p$2 && p$2(n, t);
}, a$2.__r = function(n) {
	l$1 && l$1(n), t$2 = 0;
	var i = (r$1 = n.__c).__H;
	i && (u$2 == r$1 ? r$1.__h = [] : (i.__h.some(C), i.__h.some(D), t$2 = 0), i.__h = [], i.__.some(function(n) {
		n.__N && (n.__ = n.__N), n.u = n.__N = void 0;
	})), u$2 = r$1;
}, a$2.diffed = function(n) {
	m$2 && m$2(n);
	var t = n.__c;
	t && t.__H && (t.__H.__h.length && B(c$1.push(t)), t.__H.__.some(function(n) {
		n.u && (n.__H = n.u);
	})), u$2 = r$1 = null;
}, a$2.__c = function(n, t) {
	t.some(function(n) {
		try {
			n.__h.some(C), n.__h = n.__h.filter(function(n) {
				return !n.__ || D(n);
			});
		} catch (t) {
			n.__h = [function() {
				throw t;
			}];
		}
	}), h$2 && h$2(n, t);
}, a$2.unmount = function(n) {
	s$1 && s$1(n);
	var t, r, u = n.__c;
	u && u.__H && (u.__H.__.some(function(u) {
		try {
			if (u.__P && u.__c) {
				if (void 0 === r) {
					for (r = n.__; r && (!r.__c || !r.__c.__P);) r = r.__;
					r = r && r.__c;
				}
				u.__P = r, B(e$1.push(u));
			} else C(u);
		} catch (n) {
			t = n;
		}
	}), u.__H = void 0, t && a$2.__e(t, u.__v));
};
var k$1 = "function" == typeof requestAnimationFrame;
function z(n) {
	var t, r = function() {
		clearTimeout(u), k$1 && cancelAnimationFrame(t), setTimeout(n);
	}, u = setTimeout(r, 35);
	k$1 && (t = requestAnimationFrame(r));
}
function B(n) {
	1 != n && i$1 == a$2.requestAnimationFrame || ((i$1 = a$2.requestAnimationFrame) || z)(g$2);
}
function C(n) {
	var t = r$1, u = n.__c;
	"function" == typeof u && (n.__c = void 0, u()), r$1 = t;
}
function D(n) {
	var t = r$1;
	n.__c = n.__(), r$1 = t;
}
function E(n, t) {
	return !n || n.length != t.length || t.some(function(t, r) {
		return !o$2(t, n[r]);
	});
}
// node_modules/@preact/signals-core/dist/signals-core.module.js
var i = Symbol.for("preact-signals");
function t$1() {
	if (!(v > 1)) {
		var i, t = !1;
		(function() {
			var i = c;
			c = void 0;
			while (void 0 !== i) {
				var t = i.S;
				if (t.v === i.v) {
					for (var r = t.t; void 0 !== r; r = r.x) if (r.i === i.i) r.i = t.i;
				}
				i = i.o;
			}
		})();
		while (void 0 !== h$1) {
			var r = h$1;
			h$1 = void 0;
			s++;
			while (void 0 !== r) {
				var n = r.u;
				r.u = void 0;
				r.f &= -3;
				if (!(8 & r.f) && w$1(r)) try {
					r.c();
				} catch (r) {
					if (!t) {
						i = r;
						t = !0;
					}
				}
				r = n;
			}
		}
		s = 0;
		v--;
		if (t) throw i;
	} else v--;
}
function r(i) {
	if (v > 0) return i();
	u$1 = ++e;
	v++;
	try {
		return i();
	} finally {
		t$1();
	}
}
var n;
var o$1 = void 0;
function f$1(i) {
	var t = o$1, r = n;
	o$1 = void 0;
	n = void 0;
	try {
		return i();
	} finally {
		o$1 = t;
		n = r;
	}
}
var h$1 = void 0;
var v = 0;
var s = 0;
var e = 0;
var u$1 = 0;
var c = void 0;
var a$1 = 0;
function d$1(i) {
	if (void 0 !== o$1) {
		var t = i.n;
		if (void 0 === t || t.t !== o$1) {
			t = {
				i: 0,
				S: i,
				p: o$1.s,
				n: void 0,
				t: o$1,
				e: void 0,
				x: void 0,
				r: t
			};
			if (void 0 !== o$1.s) o$1.s.n = t;
			o$1.s = t;
			i.n = t;
			if (32 & o$1.f) i.S(t);
			return t;
		} else if (-1 === t.i) {
			t.i = 0;
			if (void 0 !== t.n) {
				t.n.p = t.p;
				if (void 0 !== t.p) t.p.n = t.n;
				t.p = o$1.s;
				t.n = void 0;
				o$1.s.n = t;
				o$1.s = t;
			}
			return t;
		}
	}
}
function l(i, t) {
	this.v = i;
	this.i = 0;
	this.n = void 0;
	this.t = void 0;
	this.l = 0;
	this.W = null == t ? void 0 : t.watched;
	this.Z = null == t ? void 0 : t.unwatched;
	this.name = null == t ? void 0 : t.name;
}
l.prototype.brand = i;
l.prototype.h = function() {
	return !0;
};
l.prototype.S = function(i) {
	var t = this, r = this.t;
	if (r !== i && void 0 === i.e) {
		i.x = r;
		this.t = i;
		if (void 0 !== r) r.e = i;
		else f$1(function() {
			var i;
			null == (i = t.W) || i.call(t);
		});
	}
};
l.prototype.U = function(i) {
	var t = this;
	if (void 0 !== this.t) {
		var r = i.e, n = i.x;
		if (void 0 !== r) {
			r.x = n;
			i.e = void 0;
		}
		if (void 0 !== n) {
			n.e = r;
			i.x = void 0;
		}
		if (i === this.t) {
			this.t = n;
			if (void 0 === n) f$1(function() {
				var i;
				null == (i = t.Z) || i.call(t);
			});
		}
	}
};
l.prototype.subscribe = function(i) {
	var t = this;
	return x(function() {
		var r = t.value;
		f$1(function() {
			return i(r);
		});
	}, { name: "sub" });
};
l.prototype.valueOf = function() {
	return this.value;
};
l.prototype.toString = function() {
	return this.value + "";
};
l.prototype.toJSON = function() {
	return this.value;
};
l.prototype.peek = function() {
	var i = this;
	return f$1(function() {
		return i.value;
	});
};
Object.defineProperty(l.prototype, "value", {
	get: function() {
		var i = d$1(this);
		if (void 0 !== i) i.i = this.i;
		return this.v;
	},
	set: function(i) {
		if (i !== this.v) {
			if (s > 100) throw new Error("Cycle detected");
			(function(i) {
				if (0 !== v && 0 === s) {
					if (i.l !== u$1) {
						i.l = u$1;
						c = {
							S: i,
							v: i.v,
							i: i.i,
							o: c
						};
					}
				}
			})(this);
			this.v = i;
			this.i++;
			a$1++;
			v++;
			try {
				for (var r = this.t; void 0 !== r; r = r.x) r.t.N();
			} finally {
				t$1();
			}
		}
	}
});
function y$1(i, t) {
	return new l(i, t);
}
function w$1(i) {
	for (var t = i.s; void 0 !== t; t = t.n) if (t.S.i !== t.i || !t.S.h() || t.S.i !== t.i) return !0;
	return !1;
}
function b$1(i) {
	for (var t = i.s; void 0 !== t; t = t.n) {
		var r = t.S.n;
		if (void 0 !== r) t.r = r;
		t.S.n = t;
		t.i = -1;
		if (void 0 === t.n) {
			i.s = t;
			break;
		}
	}
}
function _$1(i) {
	var t = i.s, r = void 0;
	while (void 0 !== t) {
		var n = t.p;
		if (-1 === t.i) {
			t.S.U(t);
			if (void 0 !== n) n.n = t.n;
			if (void 0 !== t.n) t.n.p = n;
		} else r = t;
		t.S.n = t.r;
		if (void 0 !== t.r) t.r = void 0;
		t = n;
	}
	i.s = r;
}
function j(i, t) {
	l.call(this, void 0, t);
	this.x = i;
	this.s = void 0;
	this.g = a$1 - 1;
	this.f = 4;
}
j.prototype = new l();
j.prototype.h = function() {
	this.f &= -3;
	if (1 & this.f) return !1;
	if (32 == (36 & this.f)) return !0;
	this.f &= -5;
	if (this.g === a$1) return !0;
	this.g = a$1;
	this.f |= 1;
	if (this.i > 0 && !w$1(this)) {
		this.f &= -2;
		return !0;
	}
	var i = o$1;
	try {
		b$1(this);
		o$1 = this;
		var t = this.x();
		if (16 & this.f || this.v !== t || 0 === this.i) {
			this.v = t;
			this.f &= -17;
			this.i++;
		}
	} catch (i) {
		this.v = i;
		this.f |= 16;
		this.i++;
	}
	o$1 = i;
	_$1(this);
	this.f &= -2;
	return !0;
};
j.prototype.S = function(i) {
	if (void 0 === this.t) {
		this.f |= 36;
		for (var t = this.s; void 0 !== t; t = t.n) t.S.S(t);
	}
	l.prototype.S.call(this, i);
};
j.prototype.U = function(i) {
	if (void 0 !== this.t) {
		l.prototype.U.call(this, i);
		if (void 0 === this.t) {
			this.f &= -33;
			for (var t = this.s; void 0 !== t; t = t.n) t.S.U(t);
		}
	}
};
j.prototype.N = function() {
	if (!(2 & this.f)) {
		this.f |= 6;
		for (var i = this.t; void 0 !== i; i = i.x) i.t.N();
	}
};
Object.defineProperty(j.prototype, "value", { get: function() {
	if (1 & this.f) throw new Error("Cycle detected");
	var i = d$1(this);
	this.h();
	if (void 0 !== i) i.i = this.i;
	if (16 & this.f) throw this.v;
	return this.v;
} });
function O(i, t) {
	return new j(i, t);
}
function p$1(i) {
	var r = i.j;
	i.j = void 0;
	if ("function" == typeof r) {
		v++;
		var n = o$1;
		o$1 = void 0;
		try {
			r();
		} catch (t) {
			i.f &= -2;
			i.f |= 8;
			g$1(i);
			throw t;
		} finally {
			o$1 = n;
			t$1();
		}
	}
}
function g$1(i) {
	for (var t = i.s; void 0 !== t; t = t.n) t.S.U(t);
	i.x = void 0;
	i.s = void 0;
	p$1(i);
}
function S(i) {
	if (o$1 !== this) throw new Error("Out-of-order effect");
	_$1(this);
	o$1 = i;
	this.f &= -2;
	try {
		if (8 & this.f) g$1(this);
	} finally {
		t$1();
	}
}
function m$1(i, t) {
	this.x = i;
	this.j = void 0;
	this.s = void 0;
	this.u = void 0;
	this.f = 32;
	this.name = null == t ? void 0 : t.name;
	if (n) n.push(this);
}
m$1.prototype.c = function() {
	var i = this.S();
	try {
		if (8 & this.f) return;
		if (void 0 === this.x) return;
		var t = this.x();
		if ("function" == typeof t) this.j = t;
	} finally {
		i();
	}
};
m$1.prototype.S = function() {
	if (1 & this.f) throw new Error("Cycle detected");
	this.f |= 1;
	this.f &= -9;
	p$1(this);
	b$1(this);
	v++;
	var i = o$1;
	o$1 = this;
	return S.bind(this, i);
};
m$1.prototype.N = function() {
	if (!(2 & this.f)) {
		this.f |= 2;
		this.u = h$1;
		h$1 = this;
	}
};
m$1.prototype.d = function() {
	this.f |= 8;
	if (!(1 & this.f)) g$1(this);
};
m$1.prototype.dispose = function() {
	this.d();
};
function x(i, t) {
	var r = new m$1(i, t);
	try {
		r.c();
	} catch (i) {
		r.d();
		throw i;
	}
	var n = r.d.bind(r);
	n[Symbol.dispose] = n;
	return n;
}
// node_modules/@preact/signals/dist/signals.module.js
var h;
var d;
var p;
var m = "undefined" != typeof window && !!window.__PREACT_SIGNALS_DEVTOOLS__;
var g = [];
x(function() {
	h = this.N;
})();
function b(i, n) {
	n$1[i] = n.bind(null, n$1[i] || function() {});
}
function y(i) {
	if (p) {
		var n = p;
		p = void 0;
		n();
	}
	p = i && i.S();
}
function w(i) {
	var n = this, r = i.data, t = useSignal(r);
	t.name = "ReactiveDom";
	t.value = r;
	var e = w$2(function() {
		var i = n, r = n.__v;
		while (r = r.__) if (r.__c) {
			r.__c.__$f |= 4;
			break;
		}
		var o = O(function() {
			var i = t.value.value;
			return 0 === i ? 0 : !0 === i ? "" : i || "";
		}), e = O(function() {
			return !Array.isArray(o.value) && !r$2(o.value);
		}), u = x(function() {
			this.N = M$1;
			if (e.value) {
				var n = o.value;
				if (i.__v && i.__v.__e && 3 === i.__v.__e.nodeType) i.__v.__e.data = n;
			}
		}), c = n.__$u.d;
		n.__$u.d = function() {
			u();
			c.call(this);
		};
		return [e, o];
	}, []), u = e[0], c = e[1];
	return u.value ? c.peek() : c.value;
}
w.displayName = "ReactiveTextNode";
Object.defineProperties(l.prototype, {
	constructor: {
		configurable: !0,
		value: k$2($, null).constructor
	},
	type: {
		configurable: !0,
		value: w
	},
	props: {
		configurable: !0,
		get: function() {
			var i = this;
			return { data: { get value() {
				return i.value;
			} } };
		}
	},
	__b: {
		configurable: !0,
		value: 1
	}
});
b("__b", function(i, n) {
	y();
	d = void 0;
	if ("string" == typeof n.type) {
		var r, t = n.props;
		for (var f in t) if ("children" !== f) {
			var o = t[f];
			if (o instanceof l) {
				if (!r) n.__np = r = {};
				r[f] = o;
				t[f] = o.peek();
			}
		}
	}
	i(n);
});
b("__r", function(i, r) {
	i(r);
	if (r.type !== $) {
		y();
		var t, f = r.__c;
		if (f) {
			f.__$f &= -2;
			if (void 0 === (t = f.__$u)) f.__$u = t = function(i, n) {
				var r;
				x(function() {
					r = this;
				}, { name: n });
				r.c = i;
				return r;
			}(function(i) {
				return function() {
					var n;
					if (m) null == (n = this.y) || n.call(this);
					i.__$f |= 1;
					i.setState({});
				};
			}(f), "function" == typeof r.type ? r.type.displayName || r.type.name : "");
		}
		d = f;
		y(t);
	}
});
b("__e", function(i, n, r, t) {
	y();
	d = void 0;
	i(n, r, t);
});
b("diffed", function(i, n) {
	y();
	d = void 0;
	var r;
	if ("string" == typeof n.type && (r = n.__e)) {
		var t = n.__np, f = n.props, o = r.U;
		if (o) for (var e in o) {
			var u = o[e];
			if (!(void 0 === u || t && e in t)) {
				u.d();
				o[e] = void 0;
			}
		}
		if (t) {
			if (!o) {
				o = {};
				r.U = o;
			}
			for (var a in t) {
				var c = o[a], v = t[a];
				if (void 0 === c) {
					c = k(r, a, v, f);
					o[a] = c;
				} else c.o(v, f);
			}
		}
	}
	i(n);
});
function k(i, n, r, t) {
	var f = n in i && void 0 === i.ownerSVGElement, o = y$1(r);
	return {
		o: function(i, n) {
			o.value = i;
			t = n;
		},
		d: x(function() {
			this.N = M$1;
			var r = o.value.value;
			if (t[n] !== r) {
				t[n] = r;
				if (f) i[n] = r;
				else if (null != r && (!1 !== r || "-" === n[4])) i.setAttribute(n, r);
				else i.removeAttribute(n);
			}
		})
	};
}
b("unmount", function(i, n) {
	if ("string" == typeof n.type) {
		var r = n.__e;
		if (r) {
			var t = r.U;
			if (t) {
				r.U = void 0;
				for (var f in t) {
					var o = t[f];
					if (o) o.d();
				}
			}
		}
		var e = n.__np;
		if (e) {
			var u = n.props;
			for (var a in e) u[a] = e[a];
		}
		n.__np = void 0;
	} else {
		var c = n.__c;
		if (c) {
			c.__$f |= 8;
			var v = c.__$u;
			if (v) {
				c.__$u = void 0;
				v.d();
			}
		}
	}
	i(n);
});
b("__h", function(i, n, r, t) {
	if (t < 3) n.__$f |= 2;
	i(n, r, t);
});
x$1.prototype.shouldComponentUpdate = function(i, n) {
	if (this.__R) return !0;
	var r = this.__$u, t = r && void 0 !== r.s;
	for (var f in n) return !0;
	if (this.__f || "boolean" == typeof this.u && !0 === this.u) {
		var o = 2 & this.__$f;
		if (!(t || o || 4 & this.__$f)) return !0;
		if (1 & this.__$f) return !0;
	} else {
		if (!(t || 4 & this.__$f)) return !0;
		if (3 & this.__$f) return !0;
	}
	for (var e in i) if ("__source" !== e && i[e] !== this.props[e]) return !0;
	for (var u in this.props) if (!(u in i)) return !0;
	return !1;
};
function useSignal(i, n) {
	return w$2(function() {
		return y$1(i, n);
	}, []);
}
function useComputed(i, n) {
	var r = T(i);
	r.current = i;
	d.__$f |= 4;
	return w$2(function() {
		return O(function() {
			return r.current();
		}, n);
	}, []);
}
var A = function(i) {
	queueMicrotask(function() {
		queueMicrotask(i);
	});
};
function F() {
	r(function() {
		var i;
		while (i = g.shift()) h.call(i);
	});
}
function M$1() {
	if (1 === g.push(this)) (n$1.requestAnimationFrame || A)(F);
}
// src/api.ts
/** REST: who asks, with which key, and what the server says when it does not want to. */
/** A refusal of the server (RFC 9457), or of the network. */
var Refused = class extends Error {
	status;
	remedy;
	field;
	errors;
	constructor(status, message, remedy = "", field = "", errors = []) {
		super(message);
		this.status = status;
		this.remedy = remedy;
		this.field = field;
		this.errors = errors;
	}
};
var KEY = "hoistway.key";
var ACTOR = "hoistway.actor";
var TIMEOUT = 35e3;
var key$1 = sessionStorage.getItem(KEY) ?? "";
var wantsKey = () => void 0;
var forbidden = () => void 0;
/** Server's clock minus ours, ms, from the Date header (whole seconds). */
var skew = 0;
function onKeyWanted(call) {
	wantsKey = call;
}
/** Whoever is here may not do what was asked for. */
function onForbidden(call) {
	forbidden = call;
}
var may = Promise.resolve();
var goOn = () => void 0;
/** Nothing is asked for but who is there, until it is known that somebody may: `letGo`. */
function holdBack() {
	may = new Promise((done) => goOn = done);
}
function letGo() {
	goOn();
}
/** The key or token that is kept; "": none. */
function held() {
	return key$1;
}
function useKey$1(given) {
	key$1 = given;
	sessionStorage.setItem(KEY, given);
}
function actor() {
	return localStorage.getItem(ACTOR) ?? "";
}
function nameActor(name) {
	localStorage.setItem(ACTOR, name.trim());
}
/** The server's time, ms. */
function serverNow() {
	return Date.now() + skew;
}
/** A header carries bytes; the server reads them as UTF-8. */
function headerText(text) {
	return String.fromCharCode(...new TextEncoder().encode(text));
}
var notNow = () => "";
/** Nothing may be asked of the plant while this says why not. */
function forbidWhile(why) {
	notNow = why;
}
/** Who is there may be said at any time, and the stream goes on. */
var ALWAYS = /^\/(session|live)(\/|$)/;
var SESSION = /^\/session(\/|$)/;
async function call(method, path, body, extra = {}) {
	const why = method === "GET" || ALWAYS.test(path) ? "" : notNow();
	if (why) throw new Refused(0, why);
	if (!SESSION.test(path)) await may;
	const headers = {
		Accept: "application/json",
		"Accept-Language": method === "GET" ? document.documentElement.lang || "en" : "en",
		...extra
	};
	if (key$1) headers["Authorization"] = `Bearer ${headerText(key$1)}`;
	if (method !== "GET" && actor()) headers["X-Actor"] = headerText(actor());
	if (body !== void 0) headers["Content-Type"] = "application/json";
	const init = {
		method,
		headers,
		signal: AbortSignal.timeout(TIMEOUT)
	};
	if (body !== void 0) init.body = JSON.stringify(body);
	let response;
	try {
		response = await fetch(`/api/v1${path}`, init);
	} catch {
		throw new Refused(0, "The server does not answer.");
	}
	const date = Date.parse(response.headers.get("date") ?? "");
	if (Math.abs(date + 500 - serverNow()) > 1500) skew = date + 500 - Date.now();
	if (response.ok) return response.status === 204 ? void 0 : await response.json();
	throw await refusal$1(response);
}
async function refusal$1(response) {
	if (response.status === 401) wantsKey();
	if (response.status === 403) forbidden();
	const problem = await response.json().catch(() => ({}));
	const text = (name) => typeof problem[name] === "string" ? problem[name] : "";
	return new Refused(response.status, text("detail") || text("title") || `${response.status} ${response.statusText}`, text("remedy"), text("field"), Array.isArray(problem["errors"]) ? problem["errors"] : []);
}
var get = (path) => call("GET", path);
var post = (path, body, extra) => call("POST", path, body, extra);
async function fetched(path) {
	await may;
	const headers = key$1 ? { Authorization: `Bearer ${headerText(key$1)}` } : {};
	const response = await fetch(`/api/v1${path}`, {
		headers,
		signal: AbortSignal.timeout(TIMEOUT)
	}).catch(() => {
		throw new Refused(0, "The server does not answer.");
	});
	if (!response.ok) throw await refusal$1(response);
	return response;
}
async function bytes(path) {
	return new Uint8Array(await (await fetched(path)).arrayBuffer());
}
/** Send a file as it is. */
async function upload(path, text, kind) {
	const headers = {
		Accept: "application/json",
		"Accept-Language": document.documentElement.lang || "en",
		"Content-Type": kind
	};
	if (key$1) headers["Authorization"] = `Bearer ${headerText(key$1)}`;
	if (actor()) headers["X-Actor"] = headerText(actor());
	await may;
	const response = await fetch(`/api/v1${path}`, {
		method: "POST",
		headers,
		body: text,
		signal: AbortSignal.timeout(TIMEOUT)
	});
	if (!response.ok) throw await refusal$1(response);
	return await response.json();
}
/** Let the browser save what a path gives. A link could not carry the access key. */
async function download(path, name) {
	const response = await fetched(path);
	const link = document.createElement("a");
	link.href = URL.createObjectURL(await response.blob());
	link.download = name;
	link.click();
	URL.revokeObjectURL(link.href);
}
async function alive$1() {
	try {
		return (await fetch("/healthz", {
			signal: AbortSignal.timeout(3e3),
			cache: "no-store"
		})).ok;
	} catch {
		return false;
	}
}
/** A name for an order that may be sent again. randomUUID exists on secure pages only. */
function freshKey() {
	const bytes = crypto.getRandomValues(/* @__PURE__ */ new Uint8Array(12));
	return `page-${Array.from(bytes, (byte) => byte.toString(16).padStart(2, "0")).join("")}`;
}
// ../app/texts/en.json
var page$1 = /*#__PURE__*/ JSON.parse("{\"live\":\"Live\",\"connecting\":\"Connecting\",\"lost\":\"Reconnecting\",\"lost_age\":\"Reconnecting · data {0} s old\",\"lost_none\":\"The server does not answer; trying again\",\"controller\":\"Controller\",\"auto\":\"Auto\",\"pausing\":\"Pausing\",\"waiting_for\":\"Roll-call: waiting for {0}\",\"vehicles\":\"Vehicles\",\"choose_vehicle\":\"Choose a vehicle…\",\"jobs\":\"Jobs\",\"open_jobs\":\"Open jobs\",\"open\":\"Open\",\"ended\":\"Ended\",\"all\":\"All\",\"reason_first\":\"Write a reason first.\",\"stopped_here\":\"stopped from the page\",\"behind_it\":\"Behind it all:\",\"wait_behind\":\"{0} vehicles wait because of this one\",\"wait_for_it\":\"Waiting\",\"no_match\":\"No job fits the filter.\",\"no_marks\":\"No alarms, closures or pauses in this time.\",\"no_jobs\":\"No jobs here.\",\"events\":\"Events\",\"no_events\":\"Nothing has happened yet.\",\"new_transfer\":\"New transfer\",\"source\":\"From\",\"destination\":\"To\",\"carrier\":\"Carrier\",\"carrier_optional\":\"as it stands there\",\"priority\":\"Priority\",\"order\":\"Order\",\"ordering\":\"Ordering…\",\"ordered\":\"Job {0} accepted\",\"choose\":\"Choose…\",\"ports\":\"Ports\",\"buffers\":\"Side buffers\",\"agv_buffers\":\"AGV buffers\",\"loaded_vehicles\":\"Vehicles with a carrier\",\"cancel\":\"Cancel\",\"abort\":\"Abort\",\"sure\":\"Sure?\",\"close\":\"Close\",\"fit\":\"Fit\",\"zoom_in\":\"Zoom in\",\"zoom_out\":\"Zoom out\",\"map\":\"Map\",\"state\":\"State\",\"activity\":\"Activity\",\"mode\":\"Mode\",\"oper\":\"Operation\",\"place\":\"Place\",\"job\":\"Job\",\"goal\":\"Goal\",\"link\":\"Link\",\"link_up\":\"up since {0}\",\"link_down\":\"down since {0}\",\"round_trip\":\"Round trip\",\"frames_io\":\"Frames in / out\",\"trouble_counts\":\"Garbled / resent / repeated\",\"seen\":\"Last status\",\"ago\":\"{0} ago\",\"dialect\":\"Dialect\",\"address\":\"Address\",\"none\":\"none\",\"empty\":\"empty\",\"loaded\":\"loaded\",\"unknown\":\"not known\",\"waits\":\"Waits\",\"held_note\":\"Held\",\"held\":\"held\",\"locked\":\"Locked out by {0}\",\"hold\":\"Hold\",\"release\":\"Release\",\"reason_of_end\":\"Why it is cancelled or aborted\",\"may_be_empty\":\"kept with the job; may stay empty\",\"reason\":\"Reason\",\"verdict\":\"What you found\",\"verdict_go_on\":\"What it reports is true: go on\",\"verdict_off_rail\":\"It is off the rail\",\"verdict_stands_at\":\"It stands at a barcode\",\"barcode\":\"Barcode\",\"your_name\":\"Your name\",\"name_hint\":\"Kept with everything that you ask for\",\"status_bits\":\"Status bits\",\"status\":\"Status\",\"tag\":\"Tag\",\"last_tag\":\"Last tag read\",\"beyond\":\"Stopped on its way to\",\"charges_now\":\"Charging\",\"cart\":\"Cart\",\"lift\":\"Lift\",\"steering\":\"Direction\",\"in_position\":\"In position\",\"path\":\"Moves taken\",\"agv_none\":\"none\",\"agv_present\":\"present\",\"agv_unknown\":\"not known\",\"agv_up\":\"up\",\"agv_down\":\"down\",\"agv_straight\":\"straight on\",\"agv_left\":\"left\",\"agv_right\":\"right\",\"agv_mark_stop\":\"stops at a mark\",\"no_status\":\"No status yet\",\"last_frames\":\"Last frames\",\"no_frames\":\"No traffic yet\",\"kind\":\"Kind\",\"port\":\"Port\",\"sbfl\":\"Side buffer, left\",\"sbfr\":\"Side buffer, right\",\"agv_buffer\":\"AGV buffer\",\"present\":\"Occupied\",\"yes\":\"yes\",\"no\":\"no\",\"believed\":\"believed\",\"verified\":\"verified\",\"provenance\":\"Known from\",\"host\":\"the host\",\"placed\":\"a vehicle put it there\",\"picked\":\"a vehicle took it\",\"person\":\"a person\",\"inferred\":\"inferred\",\"sensor\":\"its sensor\",\"plant\":\"the plant file\",\"reserved\":\"Reserved\",\"out_of_service\":\"Out of service\",\"target\":\"Target pulses\",\"use_source\":\"Order from here\",\"use_destination\":\"Order to here\",\"key_title\":\"This server wants an access key\",\"key_label\":\"Access key\",\"key_hint\":\"Kept in this tab only, until you close it.\",\"key_use\":\"Use key\",\"log_in\":\"Log in\",\"log_in_title\":\"Who are you?\",\"log_in_again\":\"Please log in again\",\"nothing_lost\":\"The server wants to know again who you are. What you were writing is still there.\",\"log_in_as_other\":\"Log in as somebody else\",\"log_out\":\"Log out\",\"password\":\"Password\",\"use_a_key\":\"Use a key instead\",\"use_password\":\"Use name and password instead\",\"account\":\"Who is here\",\"roles\":\"Roles\",\"good_until\":\"Log in again at\",\"machine_key\":\"a machine's key\",\"change_password\":\"Change the password\",\"old_password\":\"Old password\",\"new_password\":\"New password\",\"password_rule\":\"10 characters or more\",\"password_changed\":\"The new password holds\",\"needs_role\":\"This needs the role {0}. You are {1}, with {2}.\",\"role_viewer\":\"viewer\",\"role_operator\":\"operator\",\"role_maintenance\":\"maintenance\",\"role_mes\":\"MES\",\"role_admin\":\"administrator\",\"access\":\"Users and keys\",\"users\":\"Users\",\"machine_keys\":\"Keys\",\"no_users\":\"Nobody was added yet: nobody has to log in. The first one has to be an administrator.\",\"no_keys\":\"There are no keys.\",\"disabled\":\"disabled\",\"enabled\":\"may log in\",\"disable\":\"Disable\",\"enable\":\"Let log in again\",\"logged_in\":\"Last log-in\",\"never\":\"never\",\"added\":\"Added\",\"change_roles\":\"Change the roles\",\"reset_password\":\"Give a new password\",\"password_reset\":\"{0} has a new password, and is logged out\",\"add_user\":\"Add a person\",\"user_added\":\"{0} may log in now\",\"expires\":\"Good until\",\"last_used\":\"Last used\",\"revoke\":\"Revoke\",\"key_revoked\":\"{0} is good no longer\",\"key_active\":\"active\",\"key_expired\":\"expired\",\"key_revoked_state\":\"revoked\",\"issue_key\":\"Issue a key\",\"days_good\":\"Days\",\"until_revoked\":\"until it is revoked\",\"new_key\":\"The new key\",\"shown_once\":\"Copy it now: it is never shown again.\",\"copy\":\"Copy\",\"copied\":\"Copied\",\"put_away\":\"Put away\",\"audit\":\"Audit\",\"no_rows\":\"Nothing was asked for that fits.\",\"check_chain\":\"Check the chain\",\"chain_looking\":\"{0} rows looked at…\",\"chain_whole\":\"Whole: {0} rows up to #{1}, hash {2}…\",\"chain_broken\":\"Broken at #{0}: {1}\",\"what\":\"What\",\"on_what\":\"On what\",\"in_words\":\"In words\",\"carried_out\":\"carried out\",\"since_when\":\"From\",\"until_when\":\"Until\",\"newer\":\"Newer\",\"page_number\":\"page {0}\",\"walks\":\"Audit walks\",\"no_walks\":\"No walk yet.\",\"choose_walk\":\"Begin a walk, or choose one.\",\"begin_walk\":\"Begin a walk\",\"all_buffers\":\"every side buffer\",\"entered\":\"Entered\",\"begun\":\"Begun\",\"walk_open\":\"open\",\"walk_accepted\":\"accepted\",\"walk_abandoned\":\"abandoned\",\"finding\":\"Finding\",\"found_not_seen\":\"not seen\",\"found_differs\":\"differs\",\"found_moved\":\"moved since\",\"found_agrees\":\"agrees\",\"places\":\"Places\",\"expected\":\"Expected\",\"found\":\"Found\",\"enter\":\"Enter\",\"full\":\"full\",\"unread\":\"id not read\",\"entered_place\":\"{0} entered\",\"read_csv\":\"Read a CSV\",\"walk_file_columns\":\"The file needs the columns station and seen (full or empty), and perhaps seen_carrier. Save the list as CSV and fill that in.\",\"walk_file_word\":\"Line {0}: seen is full, empty, or nothing; not “{1}”.\",\"walk_file_nothing\":\"No line of the file says what was seen.\",\"walk_file_read\":\"{0} places entered from the file\",\"accept\":\"Take it for true\",\"accept_partial\":\"Take for true what was seen\",\"walk_doubtful\":\"{0} places were not seen, or have changed since: they stay as they are.\",\"stations_cut_off\":\"{0} stations cut off\",\"cut_off_now\":\"Stations that nobody can reach\",\"kept_off\":\"Routes keep off\",\"not_reachable\":\"Nobody can reach it:\",\"since_start\":\"Since the start\",\"led_round\":\"{0} vehicles led round what is closed\",\"led_quicker\":\"{0} led a quicker way\",\"slow_track\":\"{0} pieces of track slow for traffic now\",\"restrained_to\":\"at most {0} hoists on their way with jobs now\",\"weighed\":\"ways weighed anew {0} times\",\"closed_before\":\"Closed before\",\"watch\":\"Watch live\",\"watch_begin\":\"Watch\",\"watch_end\":\"End\",\"watch_hint\":\"up to {0} at a time\",\"inputs\":\"Status and inputs\",\"ask_status\":\"Ask for its status\",\"input_run\":\"Run\",\"input_home\":\"Home\",\"inputs_off\":\"All inputs off\",\"operations\":\"What was asked of it\",\"no_operations\":\"Nothing was asked of it yet.\",\"op_state_done\":\"done\",\"op_state_failed\":\"failed\",\"op_state_running\":\"under way\",\"op_state_unknown\":\"not known\",\"last_commands\":\"Last commands\",\"no_commands\":\"No command yet\",\"lines\":\"Lines\",\"no_lines\":\"No line carries several devices.\",\"stop_line\":\"Stop all drives of this line\",\"line_stopped\":\"Stop sent to all of them\",\"stage\":\"Send a vehicle here\",\"nearest_free\":\"the nearest that is free\",\"staged\":\"It is on its way\",\"park\":\"Park\",\"tell_fire\":\"There is a fire\",\"tell_earthquake\":\"There is an earthquake\",\"webhooks\":\"Webhooks\",\"no_webhooks\":\"Nobody is told of events by HTTP yet.\",\"behind\":\"Behind\",\"delivered\":\"Delivered\",\"failing_since\":\"Failing since\",\"hook_active\":\"active\",\"hook_paused\":\"paused\",\"hook_failed\":\"given up\",\"told_up_to\":\"Told up to\",\"ping\":\"Try it\",\"pinged\":\"It was taken\",\"new_secret\":\"Another secret\",\"both_sign\":\"For a day both secrets sign\",\"replay_after\":\"Again after event\",\"replay\":\"Tell again\",\"secret\":\"Secret\",\"deliveries\":\"Deliveries\",\"subscribe\":\"Tell somebody\",\"begin_after\":\"After event\",\"from_now\":\"from now on\",\"teaching_files\":\"Files\",\"teaching_raw\":\"Raw events\",\"dests_of_ports\":\"DEST of ports\",\"offsets_of_vehicles\":\"OFFSET of vehicles\",\"save_json\":\"Save as JSON\",\"save_history\":\"Save with all versions\",\"read_file\":\"Read a file\",\"imported\":\"Imported\",\"import\":\"Import\",\"import_wrong\":\"Nothing can be imported while a row is wrong.\",\"import_ready\":\"{0} was looked at; nothing has changed yet.\",\"import_none\":\"Read a file: what would become of each row stands here first.\",\"line_of_file\":\"Line\",\"fate_new\":\"new\",\"fate_changed\":\"changed\",\"fate_same\":\"the same\",\"fate_error\":\"wrong\",\"teaching_events\":\"What vehicles sent\",\"position\":\"Position\",\"from_start\":\"From the beginning\",\"compare_offsets\":\"OFFSET of two vehicles\",\"vehicle_other\":\"Other vehicle\",\"difference\":\"Difference\",\"write_by_hand\":\"Write by hand\",\"legend_carrier\":\"carrier\",\"legend_zone\":\"no-stop zone\",\"legend_door\":\"door closed, open\",\"look_idle\":\"idle\",\"look_moving\":\"moving\",\"look_waiting\":\"waiting\",\"look_handling\":\"pick / place\",\"look_charging\":\"charging\",\"look_held\":\"held\",\"look_alarm\":\"alarm\",\"look_gone\":\"absent\",\"idle\":\"idle\",\"moving\":\"moving\",\"waiting\":\"waiting\",\"busy\":\"busy\",\"settling\":\"settling\",\"absent\":\"absent\",\"off_rail\":\"off the rail\",\"locked_out\":\"locked out\",\"recovering\":\"recovering\",\"alarm\":\"alarm\",\"charging\":\"charging\",\"acquiring\":\"picking up\",\"depositing\":\"putting down\",\"paused\":\"paused\",\"removed\":\"removed\",\"not_assigned\":\"not assigned\",\"enroute\":\"en route\",\"parked\":\"parked\",\"queued\":\"queued\",\"transferring\":\"transferring\",\"cancelling\":\"cancelling\",\"aborting\":\"aborting\",\"completed\":\"completed\",\"failed\":\"failed\",\"cancelled\":\"cancelled\",\"aborted\":\"aborted\",\"in_service\":\"in service\",\"devices\":\"Devices\",\"door\":\"Door\",\"buffer\":\"Buffer\",\"charger\":\"Charger\",\"device_open\":\"open\",\"device_closed\":\"closed\",\"device_cart\":\"cart there\",\"device_no_cart\":\"no cart\",\"device_charging\":\"charging\",\"device_free\":\"free\",\"device_busy\":\"busy\",\"device_unknown\":\"not known\",\"device_error\":\"error\",\"device_silent\":\"not heard\",\"since\":\"since {0}\",\"last_word\":\"last said: {0}\",\"passing\":\"Passing\",\"charges\":\"Charging\",\"nobody\":\"nobody\",\"lock_for\":\"Locked for\",\"lock_unsure\":\"not confirmed\",\"not_locked\":\"nobody\",\"pinned\":\"Kept {0} by {1}\",\"pending\":\"Under way\",\"contradicts\":\"Differs from the books\",\"at_station\":\"Station\",\"on_line\":\"Line\",\"line_number\":\"{0} · number {1}\",\"cmd_open\":\"Open door\",\"cmd_close\":\"Close door\",\"cmd_lock\":\"Lock\",\"cmd_unlock\":\"Unlock\",\"asked\":\"Asked for: {0}\",\"drives\":\"Drives\",\"drive\":\"Drive\",\"drive_parameter_select\":\"parameter select\",\"drive_parameter_value\":\"parameter setting\",\"drive_monitoring\":\"monitoring\",\"drive_jog\":\"jog\",\"drive_error\":\"error\",\"drive_offline\":\"offline\",\"drive_not_heard\":\"not heard yet\",\"drive_online\":\"online\",\"error_fact\":\"Error\",\"operation_fact\":\"Operates\",\"output\":\"Output\",\"turn\":\"Turns\",\"cw\":\"clockwise\",\"ccw\":\"counter-clockwise\",\"distance\":\"Distance\",\"model\":\"Model\",\"moves\":\"Moves\",\"stop_reset\":\"Stop / reset\",\"parameters\":\"Parameters\",\"read_parameters\":\"Read parameters\",\"reading\":\"Read {0} of {1}\",\"no_parameters\":\"None read yet\",\"op_done\":\"{0}: done\",\"op_running\":\"{0}: asked for\",\"op_unknown\":\"It is not known whether it took effect\",\"no_model\":\"none: parameters by number\",\"map_label\":\"Map of the track. Drag to move, wheel to zoom, click what you want to know about.\",\"vehicle\":\"Vehicle\",\"alarms\":\"Alarms\",\"no_alarms\":\"Nothing is wrong.\",\"rooms\":\"Rooms\",\"find\":\"Find\",\"nothing_found\":\"Nothing of that name\",\"filter\":\"Filter\",\"more_rows\":\"{0} more\",\"show_more\":\"Show more\",\"layers\":\"Layers\",\"layer_grants\":\"Granted track\",\"layer_zones\":\"Zones\",\"layer_closures\":\"Closures\",\"layer_holds\":\"Holds and lockouts\",\"heat\":\"Heat\",\"heat_over\":\"counted over\",\"heat_hours\":\"the last {0} h\",\"heat_seen\":\"since this page was opened\",\"heat_off\":\"none\",\"heat_waiting\":\"Waiting\",\"heat_traffic\":\"Traffic\",\"little\":\"little\",\"much\":\"much\",\"follow\":\"Follow\",\"follow_hint\":\"Keep the chosen vehicle in the middle (F)\",\"keys\":\"Keys of the map\",\"key_find\":\"find something\",\"key_pan\":\"move the map\",\"key_zoom\":\"zoom\",\"key_fit\":\"show everything\",\"key_follow\":\"follow the chosen vehicle\",\"key_none\":\"choose nothing\",\"legend_soft\":\"soft zone\",\"theme_light\":\"Light colours\",\"theme_dark\":\"Dark colours\",\"idle_parked\":\"idle, parked\",\"why\":\"Why\",\"circle\":\"Circle of hoists\",\"circles_counted\":\"found {0}, over {1} since the start\",\"job_details\":\"All about this job\",\"fallbacks\":\"else {0}\",\"wished\":\"wished: {0}\",\"ordered_by\":\"Ordered by\",\"ordered_at\":\"Ordered\",\"result\":\"Result\",\"phases\":\"How long each phase took\",\"phase_queued\":\"queued\",\"phase_fetching\":\"fetching\",\"phase_carrying\":\"carrying\",\"why_vehicle\":\"Why this vehicle\",\"not_assigned_yet\":\"It has no vehicle yet.\",\"why_waits\":\"What it waited for\",\"never_waited\":\"It did not have to wait.\",\"still\":\"still\",\"left_out\":\"{0} between the first and the latest are left out\",\"to_source\":\"{0} to the source\",\"hot_lot\":\"hot lot\",\"instead_of\":\"instead of {0}: {1} nearer\",\"worth\":\"waiting counted for {0}, a change had to save {1}\",\"no_way\":\"no way\",\"change\":\"Change\",\"any\":\"any\",\"taken\":\"Done\",\"older\":\"Older ones\",\"takes\":\"Takes\",\"device\":\"Device\",\"commands\":\"Commands\",\"sent\":\"Sent\",\"recover\":\"Recover from the alarm\",\"homing_safe\":\"I have looked: homing is safe\",\"vc_status\":\"Status\",\"vc_stop_by_host\":\"Stop by host\",\"vc_stop\":\"Stop (to MANT)\",\"vc_auto\":\"Auto\",\"vc_alarm_clear\":\"Clear alarm\",\"vc_servo_on\":\"Servo on\",\"vc_servo_off\":\"Servo off\",\"vc_search_home\":\"Search home\",\"vc_go_home\":\"Go home\",\"vc_system_reset\":\"System reset\",\"vc_agv_mark_stop\":\"Stop at a mark\",\"vc_lift_up\":\"Lift up\",\"vc_lift_down\":\"Lift down\",\"vc_lift_stop\":\"Lift stop\",\"vc_charge_on\":\"Charge\",\"vc_charge_off\":\"End charging\",\"speed\":\"Speed\",\"speed_slow\":\"slow\",\"speed_normal\":\"normal\",\"speed_fast\":\"fast\",\"at_forks\":\"At forks\",\"by_hand\":\"By hand, until it is stopped\",\"hand_forward\":\"By hand: forward\",\"hand_backward\":\"By hand: backward\",\"hand_turn_left\":\"By hand: turn left\",\"hand_turn_right\":\"By hand: turn right\",\"tape_forward\":\"Along the tape\",\"tape_backward\":\"Back along the tape\",\"agv_alias\":\"To a destination by its name\",\"stands_at_tag\":\"It stands at tag\",\"tell_it\":\"Tell it so\",\"vc_pickup\":\"Pick up\",\"vc_place\":\"Put down\",\"vc_display\":\"Show\",\"display_text\":\"Text on the vehicle\",\"move\":\"Move\",\"move_to\":\"Move to barcode\",\"stop_action\":\"Stops for\",\"act_stop\":\"nothing\",\"lock_out\":\"Lock out\",\"lift_lockout\":\"Lift the lockout\",\"lockout\":\"Lockout\",\"take_out\":\"Take out of service\",\"put_back\":\"Put back in service\",\"decide\":\"Decide\",\"unpin\":\"Give back to the vehicles\",\"pin_open\":\"Keep open\",\"pin_closed\":\"Keep closed\",\"closures\":\"Closures\",\"nothing_closed\":\"Nothing is closed.\",\"draining\":\"draining\",\"closed\":\"closed\",\"ends_in\":\"ends in {0}\",\"release_wished\":\"opening wished by {0}\",\"open_it\":\"Open\",\"pause\":\"Pause\",\"resume\":\"Resume\",\"stop_zone\":\"Stop\",\"stopped\":\"stopped\",\"close_place\":\"Close\",\"close_stretch\":\"stretch of track\",\"close_edge\":\"one piece of track\",\"close_barcode\":\"barcodes\",\"close_zone\":\"zone\",\"close_from\":\"From barcode\",\"close_to\":\"To barcode\",\"purpose\":\"For\",\"traffic\":\"traffic\",\"work\":\"people at work\",\"minutes\":\"Minutes\",\"until_opened\":\"until it is opened\",\"closes_now\":\"Closed, or draining\",\"choose_on_map\":\"Click the track above, or write barcodes; then look what it would do.\",\"look_first\":\"Look first what it would do.\",\"preview\":\"Look what it would do\",\"stations_closed\":\"Stations closed:\",\"cut_off\":\"Cut off:\",\"drive_out\":\"Have to drive out:\",\"shut_in\":\"Shut in:\",\"jobs_touched\":\"{0} jobs touched\",\"routes_longer\":\"{0} of {1} routes longer\",\"routes_lost\":\"{0} lost\",\"routes_mean\":\"A route takes {0} s on average, then {1} s\",\"stations\":\"Stations\",\"carriers\":\"Carriers\",\"age\":\"Age\",\"remove\":\"Remove\",\"carrier_is\":\"A carrier is at a place\",\"write_down\":\"Write down\",\"name\":\"Name\",\"teaching\":\"Teaching\",\"proposals\":\"Proposals\",\"sessions\":\"Sessions\",\"drift\":\"Drift\",\"dry_run\":\"Dry run\",\"no_proposals\":\"Nothing was taught yet.\",\"no_sessions\":\"No session yet.\",\"no_drift\":\"Nothing is far from what it was before.\",\"dest\":\"DEST\",\"offset\":\"OFFSET\",\"old\":\"Old\",\"new\":\"New\",\"when\":\"When\",\"who\":\"Who\",\"sent_positions\":\"Sent\",\"asked_by\":\"Asked by\",\"assign\":\"Assign\",\"approve\":\"Approve\",\"approve_anyway\":\"Approve all the same\",\"reject\":\"Reject\",\"teach_port\":\"Teach a port\",\"open_session\":\"Open a session\",\"close_session\":\"Close the session\",\"abandon\":\"Abandon\",\"teach_dest\":\"Teach DEST\",\"teach_offset\":\"Teach OFFSET\",\"reference_vehicle\":\"reference vehicle: zero\",\"refused\":\"Refused\",\"changes_nothing\":\"It changes nobody's pulses.\",\"never_taught\":\"Never taught.\",\"compare\":\"Compare\",\"roll_back\":\"Roll back to v{0}\",\"ready\":\"ready\",\"collecting\":\"collecting\",\"incomplete\":\"incomplete\",\"approved\":\"approved\",\"rejected\":\"rejected\",\"abandoned\":\"abandoned\",\"ambiguous\":\"ambiguous\",\"wrong_mode\":\"wrong mode\",\"out_of_range\":\"out of range\",\"jog\":\"Jog\",\"jog_hint\":\"runs while held\",\"backups\":\"Backups and comparison\",\"note\":\"Note\",\"back_up\":\"Back up\",\"compare_with\":\"Compare with drive\",\"restore\":\"Restore\",\"restore_dry\":\"Try to restore\",\"no_differences\":\"No differences.\",\"write\":\"Write\",\"master\":\"Plant…\",\"stop_all\":\"Stop all\",\"release_fire\":\"The fire is over\",\"release_earthquake\":\"The earthquake is over\",\"more\":\"More\",\"job_id\":\"Job id\",\"given_here\":\"given by Hoistway\",\"fallbacks_label\":\"Else to (several)\",\"statistics\":\"Statistics\",\"period_hour\":\"1 hour\",\"period_shift\":\"8 hours\",\"period_day\":\"1 day\",\"period_week\":\"7 days\",\"save_csv\":\"Save as CSV\",\"table_phases\":\"Phases\",\"table_intervals\":\"Intervals\",\"table_vehicles\":\"Vehicles\",\"table_waits\":\"Waits\",\"table_places\":\"Places of waits\",\"table_late\":\"Latest lots\",\"table_open\":\"Open jobs\",\"waits_by_place\":\"Where jobs waited\",\"late_lots\":\"The latest lots\",\"open_at_end\":\"Still open at the end of the period\",\"longest_wait\":\"Longest wait\",\"waited_for\":\"What it waited for\",\"table_transfers\":\"Transfers\",\"report\":\"Report\",\"queue\":\"Queue\",\"empty_travel\":\"empty travel\",\"throughput\":\"Throughput\",\"delivery_time\":\"Delivery time\",\"waits_by_cause\":\"Waits by cause\",\"utilisation\":\"Utilisation\",\"failures\":\"Failures\",\"availability\":\"Availability\",\"phase\":\"Phase\",\"count\":\"Count\",\"mean\":\"Mean\",\"longest\":\"Longest\",\"phase_acquiring\":\"picking up\",\"phase_depositing\":\"putting down\",\"phase_total\":\"total\",\"alarms_now\":\"Now\",\"alarms_history\":\"History\",\"alarms_pareto\":\"Pareto\",\"known_to\":\"{0} knows of it since {1}\",\"acknowledge\":\"Acknowledge\",\"no_alarms_yet\":\"No alarms yet.\",\"cause\":\"Cause\",\"pareto_code\":\"by cause\",\"pareto_source\":\"by machine\",\"pareto_both\":\"by both\",\"stage_file\":\"Stage a plant file\",\"what_differs\":\"What differs\",\"text_not_kept\":\"Its text is not kept any more: it was rejected, and others after it.\",\"jobs_refused_meanwhile\":\"Until then jobs that were accepted go on; new ones to or from what goes are refused.\",\"layouts\":\"Layout\",\"no_versions\":\"No versions are kept here.\",\"version\":\"Version\",\"version_staged\":\"staged\",\"version_awaited\":\"awaited\",\"version_active\":\"active\",\"version_former\":\"former\",\"version_rejected\":\"rejected\",\"plant_file\":\"Choose a plant file…\",\"version_taken\":\"It is kept; nothing has changed in the plant.\",\"activate\":\"Activate\",\"activate_later\":\"Activate once nothing is in the way\",\"roll_back_to\":\"Roll back to it\",\"take_back\":\"Do not activate it\",\"save_file\":\"Save the file\",\"in_the_way\":\"In the way now\",\"nothing_in_the_way\":\"Nothing is in the way.\",\"lost_with_it\":\"Serves nobody any more\",\"lacking_with_it\":\"To be taught afterwards\",\"no_difference\":\"No difference to the version that runs.\",\"diff_added\":\"added\",\"diff_removed\":\"removed\",\"diff_changed\":\"changed\",\"diff_moved\":\"moved\",\"diff_renamed\":\"renamed\",\"how\":\"Change\",\"track\":\"Track\",\"at\":\"At\",\"actor\":\"Who\",\"playback\":\"Playback\",\"loading\":\"Loading …\",\"nothing_recorded\":\"Nothing was recorded yet. Playback needs playback_days above 0.\",\"past_recording\":\"A RECORDED INCIDENT\",\"past_here\":\"THE PAST\",\"past_ago\":\"{0} ago\",\"past_by\":\"exported by {0}, {1}\",\"past_no_commands\":\"Nothing can be commanded here.\",\"past_alarms_now\":\"{0} alarms now\",\"back_to_live\":\"Back to live\",\"events_of_note\":\"What happened\",\"event_before\":\"Event before\",\"event_next\":\"Next event\",\"play\":\"Play\",\"stop_playing\":\"Pause\",\"pace\":\"Pace\",\"stretch\":\"Stretch of time shown\",\"stretch_minutes\":\"10 min\",\"stretch_hour\":\"1 h\",\"stretch_shift\":\"8 h\",\"stretch_day\":\"1 day\",\"stretch_all\":\"all\",\"moment\":\"Moment\",\"link_hint\":\"Copy the address of this moment, to be sent to somebody\",\"link_copy\":\"Copy link\",\"link_copied\":\"Copied\",\"incident\":\"Incident\",\"from_moment\":\"from\",\"to_moment\":\"to\",\"take_moment\":\"take the moment shown\",\"incident_save\":\"Export as a file\",\"incident_hint\":\"opened elsewhere by: hoistway replay FILE\",\"saved_as\":\"Saved as {0}\",\"not_then\":\"There was nothing of that name at this moment, or it is not recorded.\",\"granted\":\"Granted track\",\"here\":\"here\",\"legend_granted\":\"granted track\",\"legend_planned\":\"planned way\",\"newer_rows\":\"Newer\",\"older_rows\":\"Older\",\"jobs_ordered\":\"ordered\",\"vc_agv_stop\":\"Stop\",\"bit_foup\":\"carrier\",\"bit_trav\":\"drive\",\"bit_shft\":\"shifter\",\"bit_rota\":\"rotator\",\"bit_lift\":\"lifter\",\"bit_slid\":\"slider\",\"bit_grip\":\"gripper\",\"bit_sftb\":\"drop guard\",\"bit_mode\":\"mode\",\"bit_oper\":\"operation\",\"bit_at_barcode\":\"barcode recognised\",\"bit_all_home\":\"all devices at home\",\"bit_home_known\":\"home position known\",\"bit_servos_on\":\"all servos on\",\"bit_rsv1\":\"reserved\",\"bit_rsv2\":\"reserved\",\"bit_alarm_code\":\"alarm code\",\"bit_process_code\":\"process code\",\"servo_not_ready\":\"servo not ready\",\"servo_error\":\"servo error\",\"driver_error\":\"driver error\",\"driving\":\"driving\",\"front_bumper\":\"front bumper\",\"rear_bumper\":\"rear bumper\",\"at_stop_tag\":\"stopped at a port\",\"at_sbfl\":\"stopped at a left buffer\",\"at_sbfr\":\"stopped at a right buffer\",\"at_port_sbfl\":\"stopped at port and left buffer\",\"at_port_sbfr\":\"stopped at port and right buffer\",\"at_sbfl_sbfr\":\"stopped at both buffers\",\"at_port_sbfl_sbfr\":\"stopped at port and both buffers\",\"stop\":\"stopped\",\"home\":\"home\",\"left_limit\":\"left limit\",\"right_limit\":\"right limit\",\"cw_limit\":\"clockwise limit\",\"ccw_limit\":\"counter-clockwise limit\",\"left_side\":\"left side\",\"right_side\":\"right side\",\"left_destination\":\"left destination\",\"right_destination\":\"right destination\",\"wide\":\"wide open\",\"raised\":\"raised\",\"grip_open\":\"open\",\"grip_close\":\"closed\",\"mant\":\"MANT, maintenance\",\"semi\":\"SEMI\",\"run\":\"RUN\",\"pause_oper\":\"PAUSE, an obstacle\",\"cs_open\":\"under way\",\"cs_done\":\"done\",\"cs_failed\":\"failed\",\"cs_unknown\":\"not known\",\"cs_not_sent\":\"not sent\",\"cs_settled_done\":\"done, by its status\",\"cs_settled_not_done\":\"not done, by its status\",\"vc_move\":\"Move\",\"vc_xmove\":\"Move on\",\"vc_open\":\"Open\",\"vc_close\":\"Close\",\"vc_lock\":\"Lock\",\"vc_unlock\":\"Unlock\",\"vc_agv_charge\":\"Charging\",\"vc_agv_lift\":\"Lift\",\"reliability\":\"Reliability\",\"down_minutes\":\"Down (min)\",\"failures_of\":\"What failed\",\"catalogue\":\"Catalogue of the model\",\"default_value\":\"Default\",\"range\":\"Range\",\"read_only\":\"read only\",\"while_running\":\"while running too\",\"description\":\"Description\",\"no_catalogue\":\"Nothing is known of this model: parameters go by number.\",\"backup_contents\":\"Contents\",\"in_force\":\"Values in force\",\"period_other\":\"Other\",\"period_begin\":\"From\",\"period_end\":\"Until\",\"file_kind\":\"Files as\",\"print_report\":\"Open the report to print\",\"print\":\"Print\",\"count_connections\":\"connections\",\"count_frames_in\":\"frames in\",\"count_frames_out\":\"frames out\",\"count_garbled\":\"garbled\",\"count_resends\":\"resends\",\"count_sent\":\"sent\",\"count_answered\":\"answered\",\"count_timeouts\":\"timeouts\",\"count_naks\":\"NAKs\",\"count_busies\":\"busy\",\"count_strays\":\"strays\",\"normal\":\"normal\",\"keys_past\":\"Keys of playback\",\"period_month\":\"30 days\",\"did_AbandonWalk\":\"audit walk abandoned\",\"did_AbortJob\":\"job aborted\",\"did_AcceptWalk\":\"audit walk taken for true\",\"did_AcknowledgeAlarm\":\"alarm acknowledged\",\"did_AddWebhook\":\"webhook added\",\"did_ApproveProposal\":\"teaching approved\",\"did_AskDriveStatus\":\"drive asked for its status\",\"did_AssignProposal\":\"teaching assigned to a port\",\"did_BackUpDrive\":\"drive backed up\",\"did_CancelDriveOperation\":\"operation on a drive cancelled\",\"did_CancelJob\":\"job cancelled\",\"did_ChangeJob\":\"job changed\",\"did_ChangeWebhook\":\"webhook changed\",\"did_ClosePlace\":\"track closed\",\"did_CommandAgv\":\"AGV commanded\",\"did_CommandDevice\":\"device commanded\",\"did_CommandVehicle\":\"vehicle commanded\",\"did_CompareDrive\":\"drive compared\",\"did_CreateJob\":\"job ordered\",\"did_DisplayOnVehicle\":\"text shown on a vehicle\",\"did_EndTeaching\":\"teaching session closed\",\"did_EnterSights\":\"sights entered\",\"did_HandleOnce\":\"picked up or put down by hand\",\"did_HoldVehicle\":\"vehicle held\",\"did_ImportTaught\":\"taught values imported\",\"did_JogDrive\":\"drive jogged\",\"did_JogEnd\":\"jog ended\",\"did_LiftDeviceLockout\":\"lockout of a device lifted\",\"did_LockDrive\":\"drive locked out\",\"did_LockOutDevice\":\"device locked out\",\"did_LockVehicle\":\"vehicle locked out\",\"did_MoveVehicle\":\"vehicle moved\",\"did_OpenPlace\":\"track opened\",\"did_OpenTeaching\":\"teaching session opened\",\"did_ParkVehicle\":\"vehicle parked\",\"did_PauseController\":\"all paused\",\"did_PauseZone\":\"zone paused\",\"did_PinDoor\":\"door kept open or closed\",\"did_PressDriveKey\":\"key of a drive pressed\",\"did_RaiseEmergency\":\"emergency told\",\"did_ReadDrive\":\"parameters of a drive read\",\"did_RecoverAlarm\":\"recovered from an alarm\",\"did_RejectProposal\":\"teaching rejected\",\"did_ReleaseEmergency\":\"emergency released\",\"did_ReleaseVehicle\":\"vehicle released\",\"did_RemoveWebhook\":\"webhook removed\",\"did_RenewWebhookSecret\":\"secret of a webhook renewed\",\"did_ReplayWebhook\":\"events told again\",\"did_RestoreDrive\":\"drive restored\",\"did_ResumeController\":\"all resumed\",\"did_ResumeZone\":\"zone resumed\",\"did_RollBackDest\":\"DEST rolled back\",\"did_RollBackOffset\":\"OFFSET rolled back\",\"did_SetDeviceService\":\"device taken out or put back\",\"did_SetDriveInputs\":\"inputs of a drive set\",\"did_SetService\":\"vehicle taken out or put back\",\"did_StageVehicle\":\"vehicle staged\",\"did_StartTeaching\":\"teaching started\",\"did_StartWalk\":\"audit walk begun\",\"did_StopAll\":\"all stopped\",\"did_StopDriveLine\":\"drives of a line stopped\",\"did_UnlockDrive\":\"lockout of a drive lifted\",\"did_UnlockVehicle\":\"lockout of a vehicle lifted\",\"did_UnpinDoor\":\"door given back\",\"did_WriteCarrier\":\"carrier written down\",\"did_WriteDest\":\"DEST written\",\"did_WriteDrive\":\"parameter of a drive written\",\"did_WriteOffset\":\"OFFSET written\",\"did_WriteStation\":\"station written down\",\"did_BeginLayout\":\"first plant file\",\"did_LogIn\":\"logged in\",\"did_LogOut\":\"logged out\",\"did_ChangePassword\":\"password changed\",\"did_AddUser\":\"user added\",\"did_ChangeUser\":\"user changed\",\"did_AddKey\":\"key issued\",\"did_RevokeKey\":\"key revoked\",\"did_Forbidden\":\"not allowed by the role\",\"expired\":\"expired\",\"opened\":\"opened\",\"not_known_yet\":\"Nothing is known yet: the controller has not answered.\",\"not_known_since\":\"Not known since {0}: the controller does not answer.\",\"not_known_then\":\"Nothing is known of that moment yet.\",\"no_such\":\"There is none of that name.\",\"away_never\":\"The controller has not answered yet. What stands here empty is not known.\",\"away_since\":\"The controller does not answer since {0} ({1}). All that is shown is as it was then.\",\"state_then\":\"{0} at {1}\",\"past_away\":\"Playback · the controller does not answer\",\"link_lost\":\"No answer\",\"and_more\":\"and {0} more\",\"each_by_itself\":\"Each by itself\",\"acknowledge_all\":\"Acknowledge all {0}\",\"release_all\":\"Release {0} vehicles: their reports are right\",\"all_acknowledged\":\"All acknowledged\",\"note_or_reason\":\"Note, or the reason of a release\",\"done_of\":\"{0} of {1} done\",\"no_alarms_but\":\"No alarms, but kept back or not heard: {0}\",\"no_alarms_but_title\":\"Held or locked out by people, or not heard for less than ten seconds: not counted as alarms.\",\"alarm_count_title\":\"Alarms there are now, one for each machine and code; not acknowledged yet: {0}\",\"look_count_title\":\"Vehicles that look so on the map: {0}\",\"closures_by_people\":\"Closures by people\",\"closures_title\":\"Closures that people have ordered and not opened again. What routes keep off for other reasons stands below.\",\"kept_off_title\":\"Reasons for which routes keep off something, closures by people among them: {0}, about {1} places of the track\",\"cut_off_title\":\"Stations that nobody can reach for that; jobs to them wait.\",\"against_lockout\":\"It is locked out by {0}: {1}. Lift the lockout first.\",\"against_emergency\":\"Nothing moves while a fire or an earthquake is told. Release the emergency first (Plant…).\",\"against_work\":\"It stands where people are at work: {0}, closed by {1}. Open that first.\",\"against_link\":\"It is not connected. Look at its line and power.\",\"against_recovery\":\"An alarm recovery is under way. Wait for its end.\",\"against_not_mant\":\"It is in {0}, and this needs MANT. Press 'Stop (to MANT)' first.\",\"against_mant\":\"It is in MANT, and this needs AUTO or SEMI.\",\"against_off_rail\":\"It is off the rail. Release it first.\",\"against_hold\":\"It is on hold. Release it first.\",\"against_service\":\"It is out of service. Put it back in service first.\",\"against_job\":\"It is on job {0}. Cancel the job, or let it end.\",\"against_not_auto\":\"It is not in AUTO. Recover it, or press Servo on, Search home and Auto.\",\"against_alarm\":\"It has an alarm. Recover it first.\",\"against_settling\":\"It is being asked where it is. Try again shortly.\",\"against_roll_call\":\"The roll-call still misses {0}. Connect them, or release them.\",\"against_elsewhere\":\"It is not at the station (barcode {0}) but at {1}. Move it there first.\",\"against_loaded\":\"It is loaded: it can only put down.\",\"against_empty\":\"It is empty: it can only pick up.\",\"against_runs\":\"It does not stand still. Stop it, or wait.\",\"against_agv_manual\":\"It is not in auto. The mode is changed at the AGV alone.\",\"against_agv_auto\":\"It is not in manual. The mode is changed at the AGV alone.\",\"against_no_error\":\"It reports no error to reset.\",\"against_stands\":\"It stands: this is for an AGV that drives.\",\"against_no_charger\":\"It stands at no charger. Move it to one first.\",\"against_linked\":\"It is connected and reports its place itself. Switch it off first.\",\"against_nothing_held\":\"It is not on hold: there is nothing to release.\",\"against_unknown\":\"Nothing is known of it yet.\",\"against_silent\":\"It is silent. See its line and its power.\",\"against_locked_for\":\"It is locked for {0}. Wait until that is done.\",\"against_pin\":\"{0} keeps the door otherwise. Give it back to the vehicles first.\",\"against_engaged\":\"It cannot close: {0} is in it or on the way through.\",\"against_line\":\"Its line {0} is not connected. See the tab Lines.\",\"against_offline\":\"It does not answer. Switch it on, see to its cable and its id.\",\"against_operation\":\"Operation {0} is under way. Wait for it, or cancel it.\",\"against_drive_runs\":\"The axis moves. Stop it first.\",\"against_drive_error\":\"It is in error. See what is wrong, then press Stop/Reset.\",\"against_not_jog\":\"It is not in jog. Set it to jog at its panel.\",\"against_other_vehicle\":\"The carrier is aboard {0} or being picked up: no other vehicle can have the job.\",\"the_room\":\"‘{0}’ on this page\",\"legend_unknown\":\"not known what stands there, or doubted\",\"no_room\":\"There is no room {0} on this page: this is the map.\",\"taken_back\":\"Taken back at {0}\",\"had_before\":\"before:\",\"field_key\":\"Key\",\"field_any_vehicle\":\"For any vehicle\",\"field_forgotten\":\"Made unknown\",\"field_by_person\":\"By a person\",\"field_walked\":\"Seen on a walk\",\"field_stop\":\"Stopped\",\"choose_version\":\"Choose a version to see what differs in it and what it would break.\",\"choose_proposal\":\"A proposal and what it would change are shown here once something is taught.\",\"nothing_in_period\":\"Nothing in this period.\",\"mttr_minutes\":\"MTTR (min)\",\"seconds_unit\":\"s\",\"mtbf_hours\":\"MTBF (h)\",\"field_idempotency_key\":\"Idempotency key\",\"field_fallbacks\":\"Fall-backs\",\"field_text\":\"Text\",\"field_alarm\":\"Alarm\",\"field_pickup\":\"Pick up\",\"field_target\":\"Target pulses\",\"field_confirmed\":\"Somebody has looked\",\"field_verdict\":\"Verdict\",\"field_pulses\":\"Pulses\",\"field_expected\":\"Expected\",\"field_raw\":\"Raw value\",\"field_value\":\"Value\",\"field_raw_access\":\"Raw access\",\"field_other\":\"Other drive\",\"field_model\":\"Model\",\"field_dry_run\":\"Dry run\",\"field_turn\":\"Direction\",\"field_operation\":\"Operation\",\"field_session\":\"Session\",\"field_abandon\":\"Given up\",\"field_proposal\":\"Proposal\",\"field_accept\":\"Accepted all the same\",\"field_to\":\"To version\",\"field_rows\":\"Rows\",\"field_expires\":\"Ends by itself\",\"field_closure\":\"Closure\",\"field_walk\":\"Audit walk\",\"field_partial\":\"In part\",\"field_url\":\"URL\",\"field_events\":\"Events\",\"field_after\":\"After event\",\"field_webhook\":\"Webhook\",\"field_active\":\"Active\",\"field_overlap\":\"Old secret goes on for\"}");
var remedies$1 = {
	"malformed": "Send a body that is JSON in UTF-8.",
	"method": "The paths and their methods are listed at /api/docs.",
	"too-large": "Send less at a time.",
	"invalid": "Correct it: /api/docs says what may stand there.",
	"other": "See /api/docs."
};
var sayings$1 = /*#__PURE__*/ JSON.parse("{\"named_in_brackets\":\"{0} ({1})\",\"waits_at_for_held_by\":\"{0} waits at {1} for {2} held by {3}\",\"waits_at_for_door\":\"{0} waits at {1} for door {2}\",\"waits_at_no_slot_is\":\"{0} waits at {1}: no slot is free in the queue from {2} on; first goes {3}\",\"waits_at_no_slot_is_free\":\"{0} waits at {1}: no slot is free in the queue from {2} on\",\"closed_by_for\":\"closed by {0}: {1} ({2})\",\"closed_for_work_by\":\"closed for people at work by {0}: {1} ({2})\",\"is_there_silent\":\"{0} is there, silent: {1}\",\"stands_before_an_obstacle\":\"{0} stands there before an obstacle\",\"stands_there_for\":\"{0} stands there, {1}\",\"nobody_of_that_name\":\"There is nobody of that name with that password.\",\"try_again\":\"Try again.\",\"no_key_or_session\":\"This is no key or session that is good now.\",\"log_in_or_send\":\"Log in (POST /api/v1/session), or send the header Authorization: Bearer KEY.\",\"wants_to_know\":\"This server wants to know who calls.\",\"too_many_attempts\":\"Too many attempts went wrong.\",\"try_again_in\":\"Try again in {0} s.\",\"not_the_old_password\":\"That is not the old password.\",\"administrator_can_give\":\"An administrator can give you a new one.\",\"logged_in_too_long_ago\":\"You logged in too long ago.\",\"session_has_ended\":\"The session has ended.\",\"log_in_again\":\"Log in again.\",\"looks_like_somebody\":\"{0} would look like somebody else in the audit.\",\"choose_another_name\":\"Choose another name.\",\"is_last_administrator\":\"{0} is the last administrator.\",\"password_must_not\":\"A password must not hold the name, and has at least five different characters.\",\"row_has_been_changed\":\"row {0} has been changed, or a row between {1} and {2} was taken out or put in\",\"needs_the_role\":\"{0} needs the role {1}; {2} has {3}.\",\"waits_at_zone_takes_in\":\"{0} waits at {1}: zone {2} takes in no more for now\",\"waits_at_others_have_waited\":\"{0} waits at {1}: others have waited longer for the queue from {2} on; first goes {3}\",\"waits_at_others_have_waited_longer\":\"{0} waits at {1}: others have waited longer for the queue from {2} on\",\"waits_at_the_last_slot\":\"{0} waits at {1}: the last slot in the queue from {2} on could close a circle of full queues; first goes {3}\",\"waits_at_the_last_slot_in\":\"{0} waits at {1}: the last slot in the queue from {2} on could close a circle of full queues\",\"waits_at_is_closed\":\"{0} waits at {1}: {2} is closed ({3})\",\"waits_at_the_roll_call\":\"{0} waits at {1}: the roll-call still misses {2}\",\"waits_at\":\"{0} waits at {1}: {2}\",\"which_excludes_track\":\"{0}, which excludes track\",\"in_zone\":\"{0} in zone {1}\",\"which_is_picking_up_at\":\"{0}, which is picking up at {1} ({2} s)\",\"which_is_putting_down_at\":\"{0}, which is putting down at {1} ({2} s)\",\"which_is_used_for_teaching\":\"{0}, which is used for teaching (session {1})\",\"which_is_silent\":\"{0}, which is silent ({1})\",\"which_has_an_alarm\":\"{0}, which has an alarm\",\"which_is_being_asked_where\":\"{0}, which is being asked where it is\",\"which_is_moving\":\"{0}, which is moving\",\"used_for_teaching\":\"used for teaching (session {0})\",\"which_waits_itself\":\"{0}, which waits itself\",\"which_is_idle_there\":\"{0}, which is idle there\",\"which_is\":\"{0}, which is {1}\",\"wait_for_each_other_in\":\"{0} wait for each other in a circle ({1}); if none finds another way, move {2} by hand, or take it off the rail\",\"fire_told_by\":\"fire, told by {0}\",\"earthquake_told_by\":\"earthquake, told by {0}\",\"controller_is_paused\":\"the controller is paused\",\"controller_is_pausing\":\"the controller is pausing\",\"the_controller_is\":\"the controller is {0}\",\"everything_is_stopped_by\":\"everything is stopped by {0}\",\"the_roll_call_still_misses\":\"the roll-call still misses {0}\",\"no_vehicle_is_free_is\":\"no vehicle is free: {0} is on job {1}, and {2}\",\"no_vehicle_is_free_and\":\"no vehicle is free: {0} {1}, and {2}\",\"no_vehicle_is_free\":\"no vehicle is free\",\"no_vehicle_can_serve_both\":\"no vehicle can serve both stations: see their DEST, OFFSET and limits\",\"cannot_serve_both_stations\":\"cannot serve both stations\",\"cannot_serve\":\"cannot serve {0}: {1}\",\"is_not_connected\":\"is not connected\",\"is_not_ready\":\"is not ready\",\"it_is_not_ready\":\"it is not ready\",\"is_not_free\":\"is not free\",\"is_on_job\":\"is on job {0}\",\"is_on_job_for_s\":\"is on job {0} for {1} s more\",\"would_have_had_to_be\":\"would have had to be switched for too little\",\"has_the_carrier_aboard\":\"has the carrier aboard\",\"is_asked_for\":\"is asked for\",\"is_used_for_teaching_session\":\"is used for teaching (session {0})\",\"it_waits_for_which_will\":\"it waits for {0}, which will soon be free nearby\",\"brings_a_carrier_to_first\":\"{0} brings a carrier to {1} first\",\"other_jobs_to_come_first\":\"other jobs to {0} come first\",\"another_job_is_being_fetched\":\"another job is being fetched from {0}\",\"is_the_destination_of_already\":\"{0} is the destination of {1} already\",\"the_track_carries_no_more\":\"the track carries no more just now: {0} vehicles may be on their way with jobs\",\"is_empty_its_buffer_reports\":\"{0} is empty: its buffer reports no cart\",\"is_empty\":\"{0} is empty\",\"is_empty_is_at\":\"{0} is empty: {1} is at {2}\",\"cancelled_by_because\":\"cancelled by {0}: {1}\",\"aborted_by\":\"aborted by {0}\",\"aborted_by_because\":\"aborted by {0}: {1}\",\"fall_back_is_the_destination\":\"fall-back {0} is the destination\",\"fall_back_is_named_twice\":\"fall-back {0} is named twice\",\"name_other_stations_or_leave\":\"name other stations, or leave it out\",\"cannot_be_where_nobody_knows\":\"{0} cannot be where nobody knows whether something stands.\",\"send_present_true_with_it\":\"Send present true with it, or leave carrier out.\",\"holds_not\":\"{0} holds {1}, not {2}\",\"is_at_not_at\":\"{0} is at {1}, not at {2}\",\"is_out_of_service\":\"{0} is out of service: {1}\",\"goes_with_version\":\"{0} is not in version {1} of the plant, which is to become active\",\"cut_off_by_version\":\"{0} cannot be reached in version {1} of the plant, which is to become active\",\"is_reserved\":\"{0} is reserved: {1}\",\"is_occupied_its_buffer_reports\":\"{0} is occupied: its buffer reports a cart\",\"is_occupied_by\":\"{0} is occupied by {1}\",\"is_closed\":\"{0} is closed ({1})\",\"is_being_taught_by_with\":\"{0} is being taught by {1} with {2} (teaching session {3})\",\"nothing_is_aboard\":\"nothing is aboard {0}\",\"carries_not\":\"{0} carries {1}, not {2}\",\"its_destination_cannot_be_used\":\"its destination cannot be used\",\"finds_no_way\":\"{0} finds no way: {1}\",\"no_route_from_to_is\":\"no route from {0} to {1}: {2} is closed\",\"held_by\":\"held by {0}: {1}\",\"on_hold\":\"on hold: {0}\",\"off_the_rail\":\"off the rail: {0}\",\"out_of_service\":\"out of service: {0}\",\"locked_out_by\":\"locked out by {0}: {1}\",\"locked_out\":\"locked out: {0}\",\"stopped_by\":\"stopped by {0}\",\"release_it_when_it_may\":\"release it when it may go on\",\"it_is_not_connected\":\"it is not connected: {0}\",\"not_connected_yet\":\"not connected yet\",\"the_link_was_lost\":\"the link was lost\",\"it_drives_where_it_may\":\"it drives where it may not\",\"is_in_alarm\":\"is in ALARM {0}\",\"has_an_alarm\":\"{0} has an alarm\",\"has_its_servos_off_send\":\"has its servos off: send SERVO ON, SEARCH HOME, AUTO\",\"has_not_found_its_home\":\"has not found its home position: send SEARCH HOME\",\"has_an_axis_that_is\":\"has an axis that is not at home\",\"reads_no_barcode_bring_it\":\"reads no barcode: bring it to one by hand\",\"reports_barcode_which_is_not\":\"reports barcode {0}, which is not on the map (is its dialect right?)\",\"it_reports_barcode_at_seq\":\"it reports barcode {0} at SEQ {1}, where its path has {2}\",\"it_reports_barcode_which_cannot\":\"it reports barcode {0}, which cannot be reached from the track it held ({1})\",\"reports_barcode_which_is_not_on\":\"{0} reports barcode {1}, which is not on the track it holds\",\"reports_from_on_track_that\":\"{0} reports from {1}, on track that {2} has been granted ({3})\",\"it_carries_a_that_no\":\"it carries a {0} that no job or record accounts for\",\"it_should_carry_and_its\":\"it should carry {0}, and its {1} bit is 0\",\"its_place_ended_in_and\":\"its PLACE ended in {0}, and its {1} bit is 0\",\"clear_the_cause_then_post\":\"clear the cause, then POST /api/v1/vehicles/{0}/recover\",\"see_what_is_wrong_then\":\"see what is wrong, then POST /api/v1/vehicles/{0}/recover\",\"mend_the_cause_then_post\":\"mend the cause, then POST /api/v1/vehicles/{0}/recover again\",\"post_api_v_vehicles_recover\":\"POST /api/v1/vehicles/{0}/recover again once it is back\",\"not_homed_because_let_a\":\"not homed, because {0}; let a person look, and confirm\",\"nothing_came_of_it_for\":\"nothing came of it for {0} s\",\"look_where_it_stands_then\":\"look where it stands, then release it with verdict go_on\",\"look_where_it_stands_bring\":\"look where it stands, bring it to a barcode it reads, then release it with verdict go_on\",\"look_where_it_stands_release\":\"look where it stands; release it with verdict go_on if the barcode is right\",\"release_it_with_verdict_go\":\"release it with verdict go_on if it stands on the rail again\",\"look_at_the_vehicle_and\":\"look at the vehicle and its way, then release it\",\"see_that_its_way_is\":\"see that its way is free, then release it\",\"see_that_the_carrier_stands\":\"see that the carrier stands where it should, then release the vehicle with verdict go_on\",\"see_what_it_carries_put\":\"see what it carries, PUT /api/v1/carriers/ID for it, then release the vehicle with verdict go_on\",\"find_the_carrier_correct_its\":\"find the carrier, correct its place, then release the vehicle with verdict go_on (its job will fail)\",\"look_whether_the_carrier_is\":\"look whether the carrier is aboard or at the station, correct it, then release the vehicle\",\"look_at_the_vehicle_and_the\":\"look at the vehicle and the station, change the job's destination if need be, then release the vehicle\",\"ended_abnormally_times\":\"ended abnormally {0} times ({1})\",\"ended_abnormally\":\"{0} ended abnormally ({1})\",\"no_reason_given\":\"no reason given\",\"pickup_refused_by_the_vehicle\":\"PICKUP refused by the vehicle\",\"place_at_was_refused_times\":\"PLACE at {0} was refused {1} times\",\"the_carrier_is_aboard_order\":\"the carrier is aboard: order vehicle -> place for it\",\"aborted_the_carrier_is_aboard\":\"aborted; the carrier is aboard: order vehicle -> place for it\",\"aborted_nothing_is_aboard\":\"aborted; nothing is aboard\",\"the_carrier_is_no_longer\":\"the carrier is no longer aboard\",\"is_silent\":\"is silent: {0}\",\"is_silent_2\":\"{0} is silent: {1}\",\"see_its_line_and_its\":\"see its line and its power\",\"look_at_its_line_and\":\"look at its line and power\",\"reports_an_error\":\"reports an error (255)\",\"does_not_know_its_state\":\"does not know its state (3)\",\"look_at_the_device_then\":\"look at the device, then command it again\",\"is_not_open_and_cannot\":\"is not open, and {0} cannot be stopped before it any more\",\"look_at_and\":\"look at {0} and {1}\",\"reports_no_cart_but_is\":\"reports no cart, but {0} is believed at {1}\",\"look_there_then_put_api\":\"look there, then PUT /api/v1/stations/ID with what is there\",\"the_line_is_down\":\"the line is down: {0}\",\"is_locked_for\":\"{0} is locked for {1}\",\"is_locked_out_by\":\"{0} is locked out by {1}\",\"is_locked_out_by_already\":\"{0} is locked out by {1} already\",\"the_lockout_is_s_your\":\"the lockout is {0}'s; your wish to lift it is noted\",\"alone_can_lift_it_or\":\"{0} alone can lift it, or one more person with you\",\"lift_the_lockout_first\":\"lift the lockout first\",\"is_s_for_people_at\":\"{0} is {1}'s, for people at work; your wish to open it is noted\",\"alone_can_open_it_or\":\"{0} alone can open it, or one more person with you\",\"a_closure_for_people_s\":\"a closure for people's work never ends by itself\",\"there_is_no_station\":\"there is no station {0}\",\"there_is_no_vehicle\":\"there is no vehicle {0}\",\"there_is_no_barcode\":\"there is no barcode {0}\",\"there_is_no_station_or\":\"there is no station or vehicle {0}\",\"source_and_destination_are_the\":\"source and destination are the same station\",\"no_vehicle_serves_both_and\":\"no vehicle serves both {0} and {1}\",\"order_two_jobs_and_let\":\"order two jobs, and let the carrier change over between them\",\"the_carrier_is_aboard\":\"the carrier is aboard {0}\",\"the_carrier_is_aboard_or\":\"the carrier is aboard {0} or being picked up\",\"job_is_the_carrier_is\":\"job {0} is {1}: the carrier is aboard or being picked up\",\"job_is_nothing_was_picked\":\"job {0} is {1}: nothing was picked up\",\"job_has_ended\":\"job {0} has ended: {1}\",\"order_a_new_job\":\"order a new job\",\"is_not_connected_2\":\"{0} is not connected: {1}\",\"is_not_in_auto\":\"{0} is not in AUTO\",\"is_handling_a_carrier\":\"{0} is handling a carrier\",\"wait_for_its_end\":\"wait for its end\",\"is_on_job_2\":\"{0} is on job {1}\",\"cancel_the_job_or_let\":\"cancel the job, or let it end\",\"is_in_and_needs_mant\":\"{0} is in {1}, and {2} needs MANT\",\"send_stop_first_it_brings\":\"send stop first: it brings the vehicle to MANT\",\"nothing_needs_to_be_done\":\"nothing needs to be done\",\"is_in_auto_homed_and\":\"{0} is in AUTO, homed and without an alarm\",\"homing_now_could_drop_a\":\"homing {0} now could drop a carrier: {1}\",\"let_a_person_look_at\":\"let a person look at the vehicle, then send {\\\"confirmed\\\": true}\",\"still_has_an_alarm\":\"{0} still has an alarm\",\"nothing_moves\":\"nothing moves: {0}\",\"release_the_emergency_first\":\"release the emergency first\",\"resume_it_first\":\"resume it first\",\"has_no_dest\":\"{0} has no DEST ({1})\",\"has_no_offset\":\"{0} has no OFFSET ({1})\",\"teach_it_post_api_v\":\"teach it: POST /api/v1/teaching/sessions; or PUT /api/v1/stations/{0}/dest\",\"teach_it_post_api_v_teaching\":\"teach it: POST /api/v1/teaching/sessions; or PUT /api/v1/vehicles/{0}/offset\",\"look_at_its_changes_then\":\"look at its changes, then approve or reject it\",\"teach_again_or_reject_it\":\"teach again, or reject it\",\"came_more_may_follow\":\"{0} came; more may follow\",\"wait_some_seconds\":\"wait some seconds\",\"far_from_version\":\"far from version {0}: {1}\",\"bring_to_barcode_send_it\":\"bring {0} to barcode {1}: send it the command move with action port\",\"send_the_command_stop_it\":\"send {0} the command stop: it brings it to MANT\",\"align_the_hoist_over_the\":\"align the hoist over the port, then POST start with dest or offset; or send single axes from the vehicle\",\"proposal_is\":\"proposal {0} is {1}: {2}\",\"nothing_the_session_is_over\":\"nothing: the session is over\",\"a_named_person_has_to\":\"A named person has to decide this.\",\"send_the_header_x_actor\":\"Send the header X-Actor: NAME.\",\"the_server_does_not_answer\":\"The server does not answer.\",\"there_is_no\":\"There is no {0} {1}.\",\"is_being_locked_for\":\"{0} is being locked for {1}\",\"to_the_source\":\"to the source: {0}\",\"is_farther\":\"is farther\",\"does_job\":\"does {0}\",\"keeps_job\":\"keeps {0}\",\"status_shows_it\":\"Status shows it\",\"by_the_place_where_the_vehicle\":\"by the place where the vehicle stands\",\"first_start_on_this_database\":\"the first start on this database\",\"accepted_by_it\":\"accepted\",\"and_f_agrees\":\"RESULT {0} and F agrees\",\"cannot_go_on\":\"{0} cannot go on: {1}\",\"it_is_due_to_charge\":\"it is due to charge\",\"plant_file_itself\":\"plant file\",\"stretch_is_closed\":\"{0} to {1} is closed ({2})\",\"stretch_is_closed_by\":\"{0} to {1} is closed by {2}: {3} ({4})\",\"is_closed_by\":\"{0} is closed by {1}: {2} ({3})\",\"cannot_be_reached\":\"{0} cannot be reached: {1}\",\"ways_lead_round\":\"ways lead round {0}\",\"closure_number\":\"closure {0}\",\"may_stand_at_where_a_pick\":\"{0} may stand at {1}, where a pick-up failed: look, then PATCH /api/v1/stations/{2} with present\",\"not_known_a_pick_up_failed\":\"not known: a pick-up failed there\",\"nobody_knows_where_it_is\":\"nobody knows where it is: {0}\",\"took_from_instead\":\"{0} took {1} from {2} instead\",\"put_down_at\":\"{0} put {1} down at {2}\",\"can_be_reached_again\":\"{0} can be reached again\",\"they_can_be_reached_again\":\"they can be reached again\",\"move_away_what_stands\":\"move away what stands there, or open what is closed; jobs to there wait, and go on then\",\"stretch_has_expired\":\"{0} to {1} has expired ({2})\",\"has_expired\":\"{0} has expired ({1})\",\"stretch_is_opened_by\":\"{0} to {1} is opened by {2} ({3})\",\"is_opened_by\":\"{0} is opened by {1} ({2})\",\"no_way_leads\":\"no way leads from {0} to {1}: {2}\",\"the_mode_is_changed_at\":\"the mode is changed at the AGV alone (ENIG has no command for it)\",\"is_an_agv_is_a\":\"{0} is an AGV: {1} is a hoist's command\",\"agvs_take_stop_alarm_clear\":\"AGVs take stop, alarm_clear and the agv_ commands; {0}\",\"reports_no_error_to_reset\":\"{0} reports no error to reset\",\"leave_it_as_it_is\":\"leave it as it is\",\"is_an_agv_and_has\":\"{0} is an AGV, and has no display: {1} is not shown\",\"send_display_to_a_hoist\":\"send display to a hoist\",\"is_an_agv_it_has\":\"{0} is an AGV: it has no stop {1}\",\"leave_action_out_or_send\":\"leave action out, or send stop\",\"is_a_hoist_agv_commands\":\"{0} is a hoist: agv_ commands are for AGVs\",\"send_it_a_hoist_s\":\"send it a hoist's\",\"stands\":\"{0} stands\",\"send_it_to_an_agv\":\"send it to an AGV that drives\",\"an_agv_is_sent_to\":\"an AGV is sent to a tag by move\",\"send_move_with_the_barcode\":\"send move with the barcode\",\"is_no_agv_s_command\":\"{0} is no AGV's command here\",\"send_stop_or_alarm_clear\":\"send stop or alarm_clear\",\"is_in\":\"{0} is in {1}\",\"switch_it_to_at_the\":\"switch it to {0} at the AGV: {1}\",\"is_in_error\":\"{0} is in error\",\"does_not_stand_still\":\"{0} does not stand still\",\"stop_it_or_wait\":\"stop it, or wait\",\"there_is_no_tag_on\":\"there is no tag {0} on the floor of AGVs\",\"see_get\":\"see GET {0}\",\"lift_that_first\":\"lift that first\",\"stands_at_no_charger_told\":\"{0} stands at no charger: told to charge, it would drive to one on a way of its own\",\"send_move_to_one_of\":\"send move to one of {0} first\",\"it_is_not_known_where\":\"it is not known where {0} is\",\"wait_until_it_has_reported\":\"wait until it has reported\",\"moveauto_follows_the_tape_until\":\"MoveAuto follows the tape until it is stopped, and {0} may be on the same floor\",\"send_move_to_a_tag\":\"send move to a tag; or let the others be taken off the floor (verdict off_rail)\",\"lets_it_follow_the_tape\":\"{0} lets it follow the tape\",\"stop_it_then_release_it\":\"stop it, then release it with verdict go_on where it stands\",\"there_is_no_alias\":\"there is no alias {0}\",\"known_are\":\"known are: {0}\",\"may_choose_another_way_to\":\"{0} may choose another way to {1} than the one that would be granted\",\"send_move_to_it_leads\":\"send move to {0}: it leads there tag by tag\",\"the_way_to_is_not\":\"the way to {0} is not free: {1}\",\"wait_or_send_move_to\":\"wait, or send move to {0}: it goes as far as it may\",\"it_is_not_known_what\":\"it is not known what became of {0}: {1}\",\"no_acknowledgement_after_four_transmissi\":\"no acknowledgement after four transmissions\",\"acknowledged_but_no_answer_in\":\"acknowledged, but no answer in time\",\"another_one_has_begun\":\"another one has begun\",\"there_is_no_alarm\":\"there is no alarm {0}\",\"find_out_who_that_is\":\"find out who that is: a vehicle with a wrong address or DEV_ID, another controller's, or an intruder\",\"a_connection_is_refused_again\":\"a connection is refused again and again: {0}\",\"the_controller_was_started_again\":\"the controller was started again\",\"it_is_not_in_the\":\"it is not in the plant any more\",\"it_is_connected_again\":\"it is connected again\",\"not_connected\":\"not connected: {0}\",\"nobody_has_been_refused_for\":\"nobody has been refused for a while\",\"alarm\":\"alarm {0}\",\"alarm_2\":\"alarm {0}: {1}\",\"recovery_stopped\":\"recovery stopped\",\"not_homed_because_let_a_2\":\"not homed, because {0}; let a person look, and confirm; {1}\",\"stopped_by_2\":\"stopped by {0}; {1}\",\"recovered_by\":\"recovered by {0}\",\"alarm_recovered\":\"{0}: alarm recovered\",\"no_name_under_alarm_codes\":\"{0} (no name under alarm_codes)\",\"no_port_of_the_plant\":\"no port of the plant is at barcode {0}\",\"bring_the_vehicle_to_a\":\"bring the vehicle to a port's barcode and teach again; or give the port in the plant file and restart\",\"share_barcode_and_no_teaching\":\"{0} share barcode {1}, and no teaching session named one\",\"post_api_v1_teaching_proposals\":\"POST /api/v1/teaching/proposals/{0}/assign with the station\",\"is_a_reference_vehicle_its\":\"{0} is a reference vehicle: its OFFSET is zero by declaration\",\"reject_it_or_take_reference\":\"reject it, or take `reference` out of the plant file\",\"sent_it_in_and_teaching\":\"{0} sent it in {1}, and teaching needs MANT\",\"did_not_come\":\"{0} did not come: {1}\",\"has_no_offset_so_no\":\"{0} has no OFFSET ({1}), so no DEST can be derived from what it sent\",\"teach_at_a_reference_port\":\"teach {0} at a reference port, or PUT /api/v1/vehicles/{1}/offset\",\"has_no_dest_so_no\":\"{0} has no DEST ({1}), so no OFFSET can be derived from what {2} sent there\",\"teach_with_a_vehicle_of\":\"teach {0} with a vehicle of known OFFSET, or PUT /api/v1/stations/{1}/dest\",\"is_not_in_the_plant\":\"{0} is not in the plant any more\",\"shft_is_outside\":\"SHFT {0} is outside {1}\",\"rota_is_outside\":\"ROTA {0} is outside {1}\",\"lift_is_outside\":\"LIFT {0} is outside {1}\",\"shft_is_outside_of\":\"SHFT {0} is outside {1} of {2}\",\"rota_is_outside_of\":\"ROTA {0} is outside {1} of {2}\",\"lift_is_outside_of\":\"LIFT {0} is outside {1} of {2}\",\"shft_for_is_outside_of\":\"SHFT {0} for {1} is outside {2} of {3}\",\"rota_for_is_outside_of\":\"ROTA {0} for {1} is outside {2} of {3}\",\"lift_for_is_outside_of\":\"LIFT {0} for {1} is outside {2} of {3}\",\"or_correct_the_vehicle_s\":\"or correct the vehicle's limits in the plant file\",\"or_approve_with_accept\":\"or approve with {\\\"accept\\\": [\\\"{0}\\\"]}\",\"what_follows_from_it_does\":\"what follows from it does not fit in 32 bits\",\"are_still_not_known_afterwards\":\"{0} are still not known afterwards: jobs stay refused\",\"and_more_are_out_of\":\"and {0} more are out of range\",\"out_of_range_for\":\"out of range for {0}: {1}\",\"out_of_range_at\":\"out of range at {0}: {1}\",\"by_the_plant_file\":\"by the plant file\",\"is_off_the_rail\":\"{0} is off the rail\",\"is_off_the_rail_2\":\"{0} is off the rail: {1}\",\"can_go_on\":\"{0} can go on\",\"in_alarm\":\"in alarm {0}\",\"in_mant\":\"in MANT\",\"in_semi\":\"in SEMI\",\"not_ready\":\"not ready\",\"stands_there_on_hold\":\"{0} stands there, on hold: {1}\",\"is_there_silent_2\":\"{0}: {1} is there, silent: {2}\",\"stands_there_before_an_obstacle\":\"{0}: {1} stands there before an obstacle\",\"stands_there\":\"{0}: {1} stands there, {2}\",\"closed_by\":\"{0}: closed by {1}: {2} ({3})\",\"to_closed_by\":\"{0} to {1}: closed by {2}: {3} ({4})\",\"closed_for_people_at_work\":\"{0}: closed for people at work by {1}: {2} ({3})\",\"to_closed_for_people_at\":\"{0} to {1}: closed for people at work by {2}: {3} ({4})\",\"is_closed_2\":\"{0}: {1} is closed ({2})\",\"is_closed_stands_there\":\"{0}: {1} is closed ({2} stands there, {3})\",\"is_closed_is_there_silent\":\"{0}: {1} is closed ({2} is there, silent: {3})\",\"to_is_closed\":\"{0}: {1} to {2} is closed ({3})\",\"is_closed_for_people_at\":\"{0} is closed for people at work by {1}: {2} ({3})\",\"to_is_closed_for_people\":\"{0} to {1} is closed for people at work by {2}: {3} ({4})\",\"zone_is_closed_by\":\"zone {0} is closed by {1}: {2} ({3})\",\"zone_is_closed_for_people\":\"zone {0} is closed for people at work by {1}: {2} ({3})\",\"zone_has_expired\":\"zone {0} has expired ({1})\",\"zone_is_opened_by\":\"zone {0} is opened by {1} ({2})\",\"zone_is_opened_by_2\":\"zone {0} is opened by {1}: {2} ({3})\",\"is_opened_by_2\":\"{0} is opened by {1}: {2} ({3})\",\"to_is_opened_by\":\"{0} to {1} is opened by {2}: {3} ({4})\",\"no_way_leads_from_to\":\"no way leads from {0} to {1}: {2} is closed ({3})\",\"no_way_leads_from_to_2\":\"no way leads from {0} to {1}: {2} to {3} is closed ({4})\",\"no_route_from_to_is_2\":\"no route from {0} to {1}: {2} is closed ({3})\",\"no_route_from_to_to\":\"no route from {0} to {1}: {2} to {3} is closed ({4})\",\"zone_is_paused_by\":\"zone {0} is paused by {1}: {2}\",\"zone_is_stopped_by\":\"zone {0} is stopped by {1}: {2}\",\"and_more\":\"{0} and {1} more\",\"and_cannot_be_reached\":\"{0} and {1} cannot be reached: {2}\",\"more\":\"{0} more\",\"and_can_be_reached_again\":\"{0} and {1} can be reached again\",\"which_is_on_hold\":\"{0}, which is on hold: {1}\",\"which_is_out_of_service\":\"{0}, which is out of service: {1}\",\"which_is_locked_out_by\":\"{0}, which is locked out by {1}: {2}\",\"which_is_off_the_rail\":\"{0}, which is off the rail: {1}\",\"is_on_hold\":\"{0} is on hold: {1}\",\"is_locked_out_by_2\":\"{0} is locked out by {1}: {2}\",\"is_on_hold_2\":\"is on hold: {0}\",\"is_locked_out_by_3\":\"is locked out by {0}: {1}\",\"is_out_of_service_2\":\"is out of service: {0}\",\"is_off_the_rail_3\":\"is off the rail: {0}\",\"is_loaded\":\"is loaded\",\"waits\":\"waits: {0}\",\"locked_out_by_2\":\"locked out by {0}\",\"empty\":\"empty, {0}\",\"occupied\":\"occupied, {0}\",\"not_known\":\"not known, {0}\",\"not_known_2\":\"not known\",\"empty_2\":\"empty\",\"occupied_2\":\"occupied\",\"reported_by\":\"reported by {0}\",\"reserved\":\"reserved: {0}\",\"reserved_out_of_service\":\"reserved: {0}, out of service: {1}\",\"reports_cart_but_says_at\":\"{0} reports {1} cart, but {2} says {3} at {4}\",\"reports_cart_but_says_at_2\":\"reports {0} cart, but {1} says {2} at {3}\",\"that_there_is_a_cart\":\"that there is a cart\",\"that_there_is_none\":\"that there is none\",\"reports_no_cart_but_is_2\":\"{0} reports no cart, but {1} is believed at {2}\",\"reports_an_error_255\":\"{0} reports an error (255)\",\"reports_an_error_255_2\":\"{0} reports an error (255); {1}\",\"does_not_know_its_state_2\":\"{0} does not know its state (3)\",\"is_not_open_and_cannot_2\":\"{0} is not open, and {1} cannot be stopped before it any more\",\"reports\":\"{0} reports {1}\",\"it_is_charging\":\"it is charging\",\"move_by_hand_or_take\":\"move {0} by hand, or take it off the rail, if none finds another way\",\"they_go_on\":\"they go on\",\"waits_for_long\":\"{0} waits for long: {1}\",\"mend_that_give_it_another\":\"mend that, give it another destination (PATCH /api/v1/jobs/{0}), or cancel it (POST /api/v1/jobs/{1}/cancel)\",\"it_waits_for_that_no_more\":\"it waits for that no more\",\"it_goes_on\":\"it goes on\",\"it_has_ended\":\"it has ended\",\"waits_2\":\"{0} waits\",\"waits_at_for_held_by_2\":\"{0} waits at {1} for {2} held by {3}; {4} waits at {5}\",\"waits_at_no_slot_is_2\":\"{0} waits at {1}: no slot is free in the queue from {2} on; first goes {3}; {4} waits at {5}\",\"waits_at_others_have_waited_2\":\"{0} waits at {1}: others have waited longer for the queue from {2} on; first goes {3}; {4} waits at {5}\",\"for_held_by\":\"{0} for {1} held by {2}\",\"for_held_by_waits_at\":\"{0} for {1} held by {2}; {3} waits at {4}\",\"for_held_by_waits_at_2\":\"{0} for {1} held by {2}; {3} waits at {4} for {5} held by {6}\",\"for_held_by_waits_at_3\":\"{0} for {1} held by {2}; {3} waits at {4} for {5} held by {6}; {7} waits at {8}\",\"no_slot_is_free_in\":\"{0}: no slot is free in the queue from {1} on; first goes {2}\",\"no_slot_is_free_in_2\":\"{0}: no slot is free in the queue from {1} on; first goes {2}; {3} waits at {4}\",\"there_is_no_zone\":\"there is no zone {0}\",\"the_plant_s_zones_are\":\"the plant's zones are {0}\",\"no_edge_leads_from_to\":\"no edge leads from {0} to {1}\",\"the_track_does_not_lead\":\"the track does not lead from {0} to {1}\",\"its_source_would_be_closed\":\"its source {0} would be closed\",\"its_destination_would_be_closed\":\"its destination {0} would be closed\",\"its_source_would_be_cut\":\"its source {0} would be cut off\",\"its_destination_would_be_cut\":\"its destination {0} would be cut off\",\"the_way_of_would_lead\":\"the way of {0} would lead elsewhere\",\"leave_expires_out_and_open\":\"leave expires out, and open it when everybody is out\",\"expires_lies_in_the_past\":\"expires lies in the past\",\"name_a_later_moment_or\":\"name a later moment, or leave it out\",\"there_is_no_closure_now\":\"there is no closure {0} now\",\"there_is_no_device\":\"there is no device {0}\",\"nothing_it_has_no_packets\":\"nothing: it has no packets of its own\",\"it_does\":\"it does {0}\",\"is_a_and_does_not\":\"{0} is a {1} and does not {2}\",\"is_kept_open\":\"{0} is kept open: {1}\",\"is_kept_closed\":\"{0} is kept closed: {1}\",\"is_kept_open_by\":\"{0} is kept open by {1}\",\"is_kept_closed_by\":\"{0} is kept closed by {1}\",\"is_kept_open_by_2\":\"{0} is kept open by {1}: {2}\",\"is_kept_closed_by_2\":\"{0} is kept closed by {1}: {2}\",\"is_kept_open_by_3\":\"{0} is kept open ({1}) by {2}\",\"is_kept_closed_by_3\":\"{0} is kept closed ({1}) by {2}\",\"delete_api_v1_devices_pin\":\"DELETE /api/v1/devices/{0}/pin first\",\"cannot_close\":\"{0} cannot close: {1}\",\"is_granted_the_way_through\":\"{0} is granted the way through it\",\"may_stand_in_it\":\"{0} may stand in it\",\"may_be_in_it\":\"{0} may be in it\",\"is_in_it\":\"{0} is in it\",\"has_not_said_where_it\":\"{0} has not said where it is since the start\",\"wait_until_it_is_through\":\"wait until it is through, or lock the door out: nobody else is granted the way then\",\"wait_until_is_done\":\"wait until {0} is done\",\"is_a_not_a_door\":\"{0} is a {1}, not a door\",\"name_a_door\":\"name a door\",\"ask\":\"ask {0}\",\"wait_a_moment\":\"wait a moment\",\"is_not_kept_open_or\":\"{0} is not kept open or closed\",\"is_given_back_to_the\":\"{0} is given back to the vehicles by {1}\",\"is_locked_out_by_4\":\"{0} is locked out ({1}) by {2}\",\"is_locked_out_no_more\":\"{0} is locked out no more by {1}\",\"is_taken_out_of_service\":\"{0} is taken out of service ({1}) by {2}\",\"is_in_service_by\":\"{0} is in service by {1}\",\"is_not_locked_out\":\"{0} is not locked out\",\"not_accepted\":\"not accepted: {0}\",\"look_at_the_device\":\"look at the device\",\"does_not\":\"does not {0}: {1}\",\"did_not\":\"did not {0}: {1}\",\"does_not_2\":\"{0} does not {1}: {2}\",\"did_not_2\":\"{0} did not {1}: {2}\",\"it_was_settled_before_it\":\"it was settled before it could be sent\",\"by_status\":\"by Status: {0}\",\"it_does_not_say_whether\":\"it does not say whether the buffer is locked\",\"nothing_is_wrong_with_it\":\"nothing is wrong with it any more\",\"see_what_is_in_its\":\"see what is in its way at the door, then open or close it\",\"see_what_is_in_its_2\":\"see what is in its way at the buffer\",\"on_its_way_is\":\"{0} on its way is {1}\",\"kept_closed_by\":\"kept closed by {0}: {1}\",\"kept_closed_by_2\":\"{0} (kept closed by {1}: {2})\",\"locked_out_by_3\":\"{0} (locked out by {1}: {2})\",\"out_of_service_2\":\"{0} (out of service: {1})\",\"silent_s\":\"{0} (silent: {1}, {2} s)\",\"closing_s\":\"{0} (closing, {1} s)\",\"opening_s\":\"{0} (opening, {1} s)\",\"moving_s\":\"{0} (moving, {1} s)\",\"closed_s\":\"{0} (closed, {1} s)\",\"error_s\":\"{0} (error, {1} s)\",\"unknown_s\":\"{0} (unknown, {1} s)\",\"silent\":\"silent: {0}\",\"does_first\":\"{0} does {1} first\",\"is_nearer_than\":\"{0} is nearer than {1}\",\"its_destination_cannot_be_used_2\":\"its destination cannot be used: {0}\",\"its_destination_cannot_be_used_3\":\"its destination cannot be used: {0} finds no way: {1}\",\"its_vehicle_stands_by\":\"its vehicle stands by: {0}\",\"is_loaded_already\":\"{0} is loaded already\",\"is_going_on_to_the\":\"{0} is {1}; going on to the fall-back {2}\",\"is_being_taught_by_with_2\":\"{0} is being taught by {1} with {2} (teaching session {3}); going on to the fall-back {4}\",\"reports_going_on_to_the\":\"{0} reports {1}; going on to the fall-back {2}\",\"finds_no_way_going_on\":\"{0} finds no way: {1}; going on to the fall-back {2}\",\"occupied_by\":\"occupied by {0}\",\"occupied_by_a_carrier\":\"occupied by a carrier\",\"occupied_its_buffer_reports_a\":\"occupied: its buffer reports a cart\",\"is_occupied_by_a_carrier\":\"{0} is occupied by a carrier\",\"cannot\":\"{0} cannot {1}: {2}\",\"pick_up\":\"pick up\",\"put_down\":\"put down\",\"picking_up\":\"picking up\",\"putting_down\":\"putting down\",\"result_0_but_f\":\"RESULT 0, but F = {0}\",\"at_was_answered_result_0\":\"{0} at {1} was answered RESULT 0, but the {2} bit is {3}\",\"by_status_2\":\"by STATUS: {0}\",\"by_status_at\":\"by STATUS at {0}\",\"aborted_look_where_the_carrier\":\"aborted; {0}: look where the carrier is\",\"aborted_without_its_vehicle_look\":\"aborted without its vehicle: look where the carrier is\",\"given_back_by\":\"given back by {0}: {1}\",\"the_carrier_was_put_down\":\"the carrier was put down already\",\"nothing_is_aboard_2\":\"nothing is aboard\",\"the_key_was_let_go\":\"the key was let go before it could begin\",\"did_not_answer_again\":\"{0} did not answer again\",\"it_was_broken_off\":\"it was broken off\",\"the_controller_was_started_again_2\":\"the controller was started again while it was under way\",\"ask_again\":\"ask again\",\"the_controller_was_started_again_3\":\"the controller was started again before anything was written\",\"the_controller_was_started_again_4\":\"the controller was started again while it was under way; what was sent may have taken effect\",\"look_at_the_drive_s\":\"look at the drive's status, and decide\",\"look_at_the_drive_and\":\"look at the drive, and compare it with a backup\",\"being_written\":\"being written\",\"there_is_no_drive\":\"there is no drive {0}\",\"pressed_stop\":\"{0} pressed stop\",\"there_is_no_drive_line\":\"there is no drive line {0}\",\"stopped_all_drives_of\":\"{0} stopped all drives of {1}\",\"it_is_now_not\":\"it is {0} now, not {1}\",\"read_it_again\":\"read it again\",\"is_compared_with_itself\":\"{0} is compared with itself\",\"name_another_drive\":\"name another drive\",\"a_model_without_a_name\":\"a model without a name\",\"backup_is_of_is\":\"backup {0} is of {1}, {2} is {3}\",\"a_file_is_of_is\":\"a file is of {0}, {1} is {2}\",\"take_another_backup\":\"take another backup\",\"is_running\":\"{0} is running\",\"stop_it_first_then_restore\":\"stop it first, then restore\",\"jogs_and_one_axis_of\":\"{0} jogs {1}, and one axis of line {2} can be jogged at a time\",\"wait_until_that_is_over\":\"wait until that is over\",\"is_in_mode_not_in\":\"{0} is in mode {1}, not in jog\",\"set_it_to_jog_at\":\"set it to jog at its panel\",\"jog_is_over\":\"jog {0} is over\",\"see_get_api_v1_operations\":\"see GET /api/v1/operations/{0}, or begin another\",\"operation_is_not_under_way\":\"operation {0} is not under way\",\"a_jog_is_released_not\":\"a jog is released, not cancelled\",\"delete_its_jog\":\"DELETE its jog {0}\",\"cancelled_by\":\"cancelled by {0}\",\"was_locked_out_by\":\"{0} was locked out by {1}\",\"lift_it_first\":\"lift it first\",\"line_of_is_not_connected\":\"line {0} of {1} is not connected: {2}\",\"switch_it_on_see_to\":\"switch it on, see to its cable and its id\",\"is_offline\":\"{0} is offline: {1}\",\"wait_for_operation_or_cancel\":\"wait for operation {0}, or cancel it\",\"is_at\":\"{0} is at {1}: {2}\",\"operations_of_are_under_way\":\"{0} operations of {1} are under way\",\"wait_or_cancel_one\":\"wait, or cancel one\",\"is_in_error_2\":\"{0} is in error {1}: {2}\",\"parameter_is_read_only\":\"parameter {0} is read-only\",\"leave_it\":\"leave it\",\"parameter_goes_in_steps_of\":\"parameter {0} goes in steps of {1}: {2} is none of them\",\"parameter_is\":\"parameter {0} is {1}\",\"parameter_is_not\":\"parameter {0} is {1}, not {2}\",\"stay_in_that_range\":\"stay in that range\",\"no_catalogue\":\"no catalogue\",\"catalogue\":\"catalogue {0}\",\"of_is_in\":\"{0} of {1} is in {2}\",\"of_is_not_in\":\"{0} of {1} is not in {2}\",\"parameter_it_has_a_raw\":\"parameter {0}: it has a raw value alone\",\"send_raw_instead_of_value\":\"send raw instead of value\",\"send_raw_access_true_if\":\"send raw_access: true if you know what it does\",\"parameter_nobody_says_what_it\":\"parameter {0}: nobody says what it may be\",\"a_raw_value_is_from\":\"a raw value is from 0 to {0}\",\"of_parameters_gave_no_value\":\"{0} of {1} parameters gave no value: {2}\",\"the_drive_may_not_have\":\"the drive may not have them: see its manual, or read them again\",\"went_offline\":\"{0} went offline: {1}\",\"did_not_give_parameters_on\":\"{0} did not give {1} parameters on end: {2}\",\"see_to_the_drive_and\":\"see to the drive and its line, then ask again\",\"gave_no_value\":\"{0} gave no value: {1}\",\"see_to_the_drive_then\":\"see to the drive, then ask again\",\"parameter_is_not_as_you\":\"parameter {0} is {1}, not {2} as you saw it\",\"look_at_it_again_then\":\"look at it again, then decide\",\"is_running_and_parameter_may\":\"{0} is running, and parameter {1} may not be written while it runs\",\"stop_it_first_post_api\":\"stop it first: POST /api/v1/drives/{0}/keys {\\\"key\\\": \\\"stop_reset\\\"}\",\"it_may_be_read_only\":\"it may be read-only or out of range: see the drive's manual\",\"parameter_has_still\":\"parameter {0} has still {1}\",\"look_at_the_drive_then\":\"look at the drive, then write again\",\"parameter_reads_back_as\":\"parameter {0} reads back as {1}\",\"nothing_was_written\":\"nothing was written: {0}\",\"skip_read_only\":\"skip: read-only\",\"skip_not\":\"skip: not {0}\",\"parameter_the_rest_was_not\":\"parameter {0}: {1}; the rest was not written\",\"not_restored\":\"not restored: {0}\",\"compare_the_drive_with_the\":\"compare the drive with the backup\",\"one_to_parameters_can_be\":\"one to {0} parameters can be watched at once\",\"watch_fewer\":\"watch fewer\",\"watch_parameters_already\":\"{0} watch parameters already\",\"end_one_of_those_watches\":\"end one of those watches\",\"there_is_no_watch\":\"there is no watch {0}\",\"it_may_be_over\":\"it may be over\",\"it_answers_again\":\"it answers again\",\"answers_again\":\"{0} answers again\",\"see_its_line_its_address\":\"see its line, its address and its power\",\"it_reports_no_error_any\":\"it reports no error any more\",\"by\":\"{0} ({1}): {2} -> {3}, by {4}\",\"by_2\":\"{0}: {1} -> {2}, by {3}\",\"when_it_is_over_post\":\"when it is over: POST /api/v1/controller/emergency/release\",\"no_fire_is_told\":\"no fire is told\",\"no_is_told\":\"no {0} is told\",\"fire_is_over\":\"fire is over: {0} ({1})\",\"earthquake_is_over\":\"earthquake is over: {0} ({1})\",\"resume_when_everything_is_in\":\"resume when everything is in order\",\"fire\":\"fire: {0} ({1})\",\"earthquake\":\"earthquake: {0} ({1})\",\"fire_told_by_2\":\"fire told by {0}: {1}\",\"told_by\":\"{0} told by {1}: {2}\",\"nothing_moves_fire\":\"nothing moves: fire\",\"nothing_moves_earthquake\":\"nothing moves: earthquake\",\"status_standing_at\":\"STATUS: standing at {0}\",\"it_reports_no_alarm_any\":\"it reports no alarm any more\",\"it_is_stopping_or_stands\":\"it is stopping, or stands\",\"could_not_be_sent_times\":\"{0} could not be sent {1} times ({2})\",\"ended_abnormally_times_2\":\"{0} ended abnormally {1} times ({2})\",\"is_no_longer_in_the\":\"{0} is no longer in the plant\",\"job_was_accepted_with_another\":\"job {0} was accepted with another body under this {1}\",\"use_a_new_for_a\":\"use a new {0} for a new job, or GET /api/v1/jobs/{1} to see the old one\",\"job_id_must_not_begin\":\"job_id must not begin with {0}\",\"leave_it_out_or_use\":\"leave it out, or use your own\",\"leave_vehicle_out\":\"leave vehicle out\",\"name_another\":\"name another\",\"if_a_carrier_is_there\":\"if a carrier is there, say so first: PUT /api/v1/carriers/ID\",\"else\":\"else {0}\",\"there_is_no_job_under\":\"there is no job {0} under way\",\"post_api_v1_jobs_abort\":\"POST /api/v1/jobs/{0}/abort\",\"post_api_v1_jobs_cancel\":\"POST /api/v1/jobs/{0}/cancel\",\"job_is_aborting\":\"job {0} is aborting\",\"job_is_cancelling\":\"job {0} is cancelling\",\"order_a_new_job_once\":\"order a new job once it has ended\",\"is_asked_for_2\":\"{0} is asked for\",\"leave_vehicle_out_only_a\":\"leave vehicle out: only a job that is queued or waiting can get another\",\"the_carrier_is_being_put\":\"the carrier is being put down at {0}\",\"wait_for_its_end_then\":\"wait for its end, then order a job from there\",\"nothing_changed\":\"nothing changed\",\"priority\":\"priority {0} -> {1}\",\"destination\":\"destination {0} -> {1}\",\"vehicle\":\"vehicle {0} -> {1}\",\"destination_2\":\"{0}, destination {1} -> {2}\",\"vehicle_2\":\"{0}, vehicle {1} -> {2}\",\"is_a_hoist_and_does\":\"{0} is a hoist, and does not serve {1}\",\"is_an_agv_and_does\":\"{0} is an AGV, and does not serve {1}\",\"name_another_vehicle_or_leave\":\"name another vehicle, or leave it out\",\"see_get_api_v1_stations\":\"see GET /api/v1/stations for those it serves\",\"reports_barcode_at_seq_where\":\"{0} reports barcode {1} at SEQ {2}, where its path has {3}\",\"the_place_of_is_not\":\"the place of {0} is not known\",\"a_door_on_its_way\":\"a door on its way is not open any more\",\"is_being_asked_where_it\":\"{0} is being asked where it is\",\"nobody_knows_where_is_put\":\"nobody knows where {0} is: PUT /api/v1/carriers/{1} with its place\",\"nobody_gets_away_from_again\":\"nobody gets away from {0} again: {1}\",\"no_mode\":\"no mode\",\"is_in_mant_needs_auto\":\"{0} is in MANT: {1} needs AUTO or SEMI\",\"send_stop\":\"send stop\",\"an_alarm_recovery_of_is\":\"an alarm recovery of {0} is under way\",\"stands_where\":\"{0} stands where {1}\",\"open_that_first\":\"open that first\",\"open_it_first\":\"open it first\",\"switch_it_to_auto\":\"switch it to AUTO\",\"switch_it_to_auto_at\":\"switch it to auto at the AGV\",\"send_servo_on_search_home\":\"send servo_on, search_home and auto, or recover it\",\"post_api_v1_vehicles_recover\":\"POST /api/v1/vehicles/{0}/recover\",\"post_api_v1_vehicles_release\":\"POST /api/v1/vehicles/{0}/release\",\"try_again_shortly\":\"try again shortly\",\"connect_them_or_post_api\":\"connect them, or POST /api/v1/vehicles/ID/release with verdict off_rail or stands_at; with go_on for one that is connected and on hold\",\"a_path_ends_in_a\":\"a path ends in a stop\",\"leave_action_out_or_name\":\"leave action out, or name a stop\",\"end_what_closes_it_kept\":\"end what closes it: kept_off in GET /api/v1/controller lists it\",\"it_can_only_now\":\"it can only {0} now\",\"is_loaded_2\":\"{0} is loaded\",\"if_it_is_not_so\":\"if it is not so, PUT /api/v1/stations/{0}\",\"is_not_stopped_at_barcode\":\"{0} is not stopped at {1} (barcode {2}) but at {3}\",\"send_move_to_with_action\":\"send move to {0} with action {1} first\",\"is_not_on_hold\":\"{0} is not on hold\",\"nothing_to_release\":\"nothing to release\",\"is_connected_and_reports\":\"{0} is connected and reports\",\"switch_it_off_and_take\":\"switch it off and take it off the rail first\",\"was_taken_off_the_rail\":\"{0} was taken off the rail\",\"said_by\":\"said by {0}: {1}\",\"is_connected_and_reports_its\":\"{0} is connected and reports its place itself\",\"use_go_on\":\"use go_on\",\"stands_at\":\"{0}: stands at {1}: {2}\",\"was_taken_out_of_service\":\"{0} was taken out of service\",\"in_service\":\"{0}: in service\",\"nothing_to_lift\":\"nothing to lift\",\"everything_is_stopped_by_2\":\"everything is stopped by {0}: {1}\",\"use_a_shorter_id_as\":\"use a shorter id, as the vehicles' displays show it\",\"carrier_must_be_at_most\":\"carrier must be at most {0} printable ASCII characters\",\"a_carrier_cannot_be_where\":\"a carrier cannot be where nothing is present\",\"leave_carrier_or_present_out\":\"leave carrier or present out\",\"holds\":\"{0} holds {1}\",\"carries\":\"{0} carries {1}\",\"move_or_remove_first\":\"move or remove {0} first\",\"says_that_nothing_is_aboard\":\"{0} says that nothing is aboard ({1} bit 0)\",\"look_where_the_carrier_is\":\"look where the carrier is, and name that place\",\"there_is_no_carrier\":\"there is no carrier {0}\",\"is_ordered_by_job\":\"{0} is ordered by job {1}\",\"cancel_or_abort_the_job\":\"cancel or abort the job first\",\"removed_from_the_plant\":\"removed from the plant\",\"is_a_side_buffer_vehicles\":\"{0} is a side buffer: vehicles know its positions themselves\",\"only_ports_have_a_dest\":\"only ports have a DEST\",\"release_it_first_post_api\":\"release it first: POST /api/v1/controller/emergency/release\",\"is_in_alarm_2\":\"{0} is in ALARM {1}\",\"is_driving\":\"{0} is driving\",\"has_its_servos_off_send_2\":\"{0} has its servos off: send SERVO ON, SEARCH HOME, AUTO\",\"has_not_found_its_home_2\":\"{0} has not found its home position: send SEARCH HOME\",\"has_an_axis_that_is_2\":\"{0} has an axis that is not at home\",\"reads_no_barcode_bring_it_2\":\"{0} reads no barcode: bring it to one by hand\",\"reports_barcode_which_is_not_2\":\"{0} reports barcode {1}, which is not on the map (is its dialect right?)\",\"it_was_said_to_be\":\"it was said to be off the rail ({0}), and reports from barcode {1}\",\"reports_barcode_which_it_could\":\"{0} reports barcode {1}, which it could not be moved to from {2}\",\"the_database_is_a_restored\":\"the database is a restored backup, and may have missed where it went and what it carries\",\"compare_its_place_load_and\":\"compare its place, load and job with the plant, correct them, then release it with verdict go_on\",\"name_another_one_or_have\":\"name another one, or have that version rejected: POST /api/v1/layout/versions/{0}/reject\",\"no_vehicle_is_free_that\":\"no vehicle is free that can go to {0}\",\"no_parking_place_is_free\":\"no parking place is free that {0} can reach\",\"stop_all\":\"stop all: {0}\",\"zone_is_stopped\":\"zone {0} is stopped: {1}\",\"zone_goes_on\":\"zone {0} goes on: {1}\",\"vehicle_is_not_in_the\":\"vehicle {0} is not in the plant file any more, but may be on the rail ({1})\",\"put_it_back_into_the\":\"Put it back into the file; once it is off the rail say so (POST /api/v1/vehicles/{0}/release, verdict off_rail), then take it out.\",\"correct_the_dest_of_the\":\"correct the DEST of the station, the OFFSET of the vehicle, or the limits in the plant file\",\"code_position_barcode_no_code\":\"code {0}, position {1}, barcode {2}: no code of teaching\",\"they_did_not_come_within\":\"they did not come within {0} s\",\"answered_without_sending_them\":\"{0} answered without sending them\",\"was_lost\":\"{0} was lost: {1}\",\"proposal_dest_at\":\"proposal {0}: dest {1} at {2}\",\"proposal_dest_at_2\":\"proposal {0}: dest {1} at {2}. {3}\",\"proposal_offset_at\":\"proposal {0}: offset {1} at {2}\",\"proposal_offset_at_2\":\"proposal {0}: offset {1} at {2}. {3}\",\"by_proposal\":\"by proposal {0}\",\"it_is_version_now_not\":\"it is version {0} now, not {1}\",\"it_is_revision_now_not\":\"it is revision {0} now, not {1}\",\"read_it_again_then_decide\":\"read it again, then decide\",\"is_a_reference_vehicle_its_2\":\"{0} is a reference vehicle: its OFFSET is zero by the plant file\",\"take_reference_out_of_the\":\"take `reference` out of the plant file first\",\"there_is_no_proposal_that\":\"there is no proposal {0} that waits for a decision\",\"cannot_be_accepted\":\"{0} cannot be accepted\",\"these_can\":\"these can: {0}\",\"proposal_by_version\":\"proposal {0} by {1}: {2} version {3}\",\"proposal_by\":\"proposal {0} by {1}: {2}\",\"is_no_port_at_barcode\":\"{0} is no port at barcode {1}\",\"ports_there\":\"ports there: {0}\",\"version_is_the_present_one\":\"version {0} is the present one\",\"name_an_older_version\":\"name an older version\",\"of_rows_of_are_new\":\"{0}: {1} of {2} rows of {3} are new versions\",\"there_is_no_open_teaching\":\"there is no open teaching session {0}\",\"is_wanted_for_teaching\":\"{0} is wanted for teaching {1}\",\"session_teaches_with\":\"session {0}: {1} teaches {2} with {3}\",\"is_no_port_nothing_is\":\"{0} is no port: nothing is taught there\",\"name_a_station_of_kind\":\"name a station of kind port\",\"is_no_hoist_it_is\":\"{0} is no hoist: it is not taught\",\"name_a_hoist\":\"name a hoist\",\"teaches_with_in_session\":\"{0} teaches {1} with {2} in session {3}\",\"close_session_first\":\"close session {0} first\",\"is_handling_a_carrier_at\":\"{0} is handling a carrier at {1}\",\"let_it_end_or_choose\":\"let it end, or choose another vehicle\",\"its_port_or_vehicle_is\":\"its port or vehicle is not in the plant any more\",\"close_the_session\":\"close the session\",\"is_sending_its_positions_already\":\"{0} is sending its positions already\",\"wait_for_its_answer\":\"wait for its answer\",\"stands_at_and_is_at\":\"{0} stands at {1}, and {2} is at {3}\",\"no_barcode_that_it_reads\":\"no barcode that it reads\",\"bring_it_to_barcode_in\":\"bring it to barcode {0}: in AUTO by the command move with action port, then send stop\",\"session_was_abandoned\":\"session {0} was abandoned\",\"session_abandoned_by\":\"session {0}: abandoned by {1}\",\"session_abandoned_by_2\":\"session {0}: abandoned by {1}. {2}\",\"session_closed_by\":\"session {0}: closed by {1}\",\"session_closed_by_2\":\"session {0}: closed by {1}. {2}\",\"listening_for_dev_id\":\"listening for DEV_ID {0}\",\"the_plant_has_no_side\":\"the plant has no side buffer\",\"name_the_stations_to_walk\":\"name the stations to walk along\",\"walk_of_is_at\":\"walk {0} of {1} is at {2}\",\"let_it_end_first\":\"let it end first\",\"walk_of\":\"walk {0} of {1}: {2}\",\"there_is_no_open_walk\":\"there is no open walk {0}\",\"is_not_on_walk\":\"{0} is not on walk {1}\",\"begin_a_walk_along_it\":\"begin a walk along it\",\"leave_carrier_out\":\"leave carrier out\",\"all_that_was_entered_has\":\"all that was entered has changed since\",\"nothing_was_entered\":\"nothing was entered\",\"look_again_or_abandon\":\"look again and enter it, or abandon the walk\",\"cannot_be_at_while_nothing\":\"{0} cannot be at {1} while nothing is present there\",\"leave_carrier_out_or_say\":\"leave carrier out, or say that something is present\",\"not_seen_or_changed_since\":\"not seen, or changed since: {0}\",\"look_there_and_enter_it\":\"look there and enter it, or send {\\\"partial\\\": true}\",\"was_seen_at_two_places\":\"{0} was seen at two places\",\"look_again_and_enter_what\":\"look again, and enter what is right\",\"places_verified_of_them_were\":\"{0} places verified, {1} of them were wrong\",\"walk_is_accepted_by\":\"walk {0} is accepted by {1}: {2}\",\"walk_is_abandoned_by\":\"walk {0} is abandoned by {1}: {2}\",\"there_is_no_webhook\":\"there is no webhook {0}\",\"mend_the_receiver_then_patch\":\"mend the receiver, then PATCH /api/v1/webhooks/{0} {\\\"active\\\": true}\",\"there_are_webhooks\":\"there are {0} webhooks\",\"remove_one_that_nobody_needs\":\"remove one that nobody needs any more\",\"the_last_event_is_number\":\"the last event is number {0}\",\"leave_after_out_to_begin\":\"leave after out to begin with the next\",\"webhook_to_has_not_taken\":\"webhook {0} to {1} has not taken event {2} for {3} h ({4})\",\"webhook_is_removed\":\"webhook {0} is removed\",\"webhook_is_active\":\"webhook {0} is active: {1}\",\"webhook_is_paused\":\"webhook {0} is paused: {1}\",\"refused\":\"refused: {0}\",\"refused_wrong_name_or_password\":\"refused: wrong name or password\",\"refused_that_is_not_the\":\"refused: that is not the old password\",\"roles\":\"roles {0}\",\"roles_for_ever\":\"roles {0}; for ever\",\"roles_until\":\"roles {0}; until {1}\",\"roles_a_new_password\":\"roles {0}, a new password\",\"roles_disabled\":\"roles {0}, disabled\",\"roles_enabled\":\"roles {0}, enabled\",\"roles_disabled_a_new_password\":\"roles {0}, disabled, a new password\",\"roles_enabled_a_new_password\":\"roles {0}, enabled, a new password\",\"disabled_a_new_password\":\"disabled, a new password\",\"enabled_a_new_password\":\"enabled, a new password\",\"disabled\":\"disabled\",\"enabled\":\"enabled\",\"a_new_password\":\"a new password\",\"from\":\"from {0}.{1}.{2}.{3}\",\"instead_of_version\":\"instead of version {0}: {1}\",\"instead_of_no_version\":\"instead of no version: {0}\",\"version_goes_on\":\"version {0} goes on\",\"a_backup_was_put_back\":\"a backup was put back\",\"took_the_wish_back\":\"{0} took the wish back: {1}\",\"to_version\":\"to version {0}: {1}\",\"rows_of_dest\":\"{0} rows of dest\",\"rows_of_offset\":\"{0} rows of offset\",\"operation_released\":\"operation {0}, released\",\"operation_caller_gone\":\"operation {0}, caller gone\",\"operation_failed\":\"operation {0}, failed: {1}\",\"operation_unknown\":\"operation {0}, unknown: {1}\",\"vehicle_reason\":\"vehicle {0}, reason {1}\",\"vehicle_verdict_go_on_reason\":\"vehicle {0}, verdict go_on, reason {1}\",\"vehicle_verdict_off_rail_reason\":\"vehicle {0}, verdict off_rail, reason {1}\",\"vehicle_verdict_stands_at_reason\":\"vehicle {0}, verdict stands_at, reason {1}, barcode {2}\",\"device_reason\":\"device {0}, reason {1}\",\"device_position_open_reason\":\"device {0}, position open, reason {1}\",\"device_position_closed_reason\":\"device {0}, position closed, reason {1}\",\"drive_reason\":\"drive {0}, reason {1}\",\"drive_note\":\"drive {0}, note {1}\",\"zone_reason_stop_false\":\"zone {0}, reason {1}, stop False\",\"zone_reason_stop_true\":\"zone {0}, reason {1}, stop True\",\"kind_fire_reason\":\"kind fire, reason {0}\",\"kind_earthquake_reason\":\"kind earthquake, reason {0}\",\"place_reason_purpose_traffic\":\"place {0}, reason {1}, purpose traffic\",\"place_reason_purpose_traffic_expires\":\"place {0}, reason {1}, purpose traffic, expires {2}\",\"place_reason_purpose_work\":\"place {0}, reason {1}, purpose work\",\"closure_reason\":\"closure {0}, reason {1}\",\"proposal_reason\":\"proposal {0}, reason {1}\",\"proposal_reason_expected\":\"proposal {0}, reason {1}, expected {2}\",\"proposal_accept_reason\":\"proposal {0}, accept {1}, reason {2}\",\"proposal_accept_reason_expected\":\"proposal {0}, accept {1}, reason {2}, expected {3}\",\"session_abandon_false\":\"session {0}, abandon False\",\"session_abandon_true\":\"session {0}, abandon True\",\"session_reason_abandon_false\":\"session {0}, reason {1}, abandon False\",\"session_reason_abandon_true\":\"session {0}, reason {1}, abandon True\",\"station_vehicle_note\":\"station {0}, vehicle {1}, note {2}\",\"walk_reason\":\"walk {0}, reason {1}\",\"walk_partial_false\":\"walk {0}, partial False\",\"walk_partial_true\":\"walk {0}, partial True\",\"alarm_note\":\"alarm {0}, note {1}\",\"reason\":\"reason {0}\",\"reason_stations\":\"reason {0}, stations {1}\",\"choose_another_one\":\"Choose another one.\",\"the_first_user_or_key\":\"The first user or key has to have the role admin: from then on everybody has to log in.\",\"add_an_administrator_first\":\"Add an administrator first.\",\"nothing_to_change_was_named\":\"Nothing to change was named.\",\"send_roles_disabled_or_password\":\"Send roles, disabled or password.\",\"send_priority_destination_or_vehicle\":\"Send priority, destination or vehicle.\",\"the_controller_is_starting\":\"The controller is starting.\",\"asks_too_often\":\"{0} asks too often.\",\"the_address_asks_too_often\":\"The address {0} asks too often.\",\"wait_s_and_ask_less\":\"Wait {0} s, and ask less often.\",\"x_actor_is_a_name\":\"X-Actor is a name of at most {0} printable characters.\",\"send_a_shorter_or_plainer\":\"Send a shorter or plainer one.\",\"the_controller_gave_no_answer\":\"The controller gave no answer within {0} s.\",\"look_at_the_object_before\":\"Look at the object before asking again; a job is safe to post again under the same id or key.\",\"get_api_v1_lists_them\":\"GET /api/v1/{0} lists them.\",\"get_api_v1_names_its\":\"GET /api/v1/{0} names its models.\",\"get_api_v1_says_since\":\"GET /api/v1/{0} says since when.\",\"see_get_api_v1\":\"See GET /api/v1/{0}.\",\"see_get_api_v1_2\":\"see GET /api/v1/{0}\",\"if_match_is_the_etag\":\"If-Match is the ETag of what was read, such as \\\"3\\\".\",\"the_end_is_said_twice\":\"The end is said twice.\",\"send_expires_or_minutes\":\"Send expires or minutes.\",\"a_closure_ends_within_a\":\"A closure ends within a year.\",\"leave_expires_out_to_close\":\"Leave expires out to close for good.\",\"the_target_is_the_number\":\"The target is the number of a closure.\",\"the_target_is_the_number_2\":\"The target is the number of a walk.\",\"connections_are_open_already\":\"{0} connections are open already.\",\"close_some_or_raise_connections\":\"Close some, or raise `connections`.\",\"the_head_of_the_request\":\"The head of the request is larger than {0} bytes.\",\"send_fewer_or_shorter_headers\":\"Send fewer or shorter headers.\",\"a_line_of_the_head\":\"A line of the head is longer than {0} bytes, or there are over {1}.\",\"speak_http_1_1_without\":\"Speak HTTP/1.1, without TLS: a proxy in front can add that.\",\"the_request_did_not_come\":\"The request did not come in whole within {0} s.\",\"send_it_again_faster\":\"Send it again, faster.\",\"backup_is_of_drive\":\"Backup {0} is of drive {1}.\",\"look_at_drive\":\"Look at drive {0}.\",\"send_either_raw_or_value\":\"send either raw or value\",\"send_either_backup_or_drive\":\"send either backup or drive\",\"has_no_jog\":\"{0} has no jog {1}.\",\"has_no_watch\":\"{0} has no watch {1}.\",\"it_may_be_over_2\":\"It may be over.\",\"watch_already\":\"{0} watch already.\",\"close_a_page_or_raise\":\"Close a page, or raise `watchers`.\",\"this_server_does_not_answer\":\"This server does not answer to the name {0}.\",\"use_localhost_or_127_0\":\"Use localhost or 127.0.0.1, add the name to allowed_hosts, or let people log in (docs/access.md).\",\"a_page_of_may_not\":\"A page of {0} may not call this server.\",\"use_the_server_s_own\":\"Use the server's own page, or add the origin to allowed_origins.\",\"the_body_is_larger_than\":\"The body is larger than {0} bytes.\",\"send_it_in_parts\":\"Send it in parts.\",\"nothing_is_recorded_for_playback\":\"Nothing is recorded for playback.\",\"set_playback_days_to_more\":\"Set playback_days to more than 0, and start the server again.\",\"nothing_was_recorded_by_then\":\"Nothing was recorded by then.\",\"nothing_was_recorded_in_that\":\"Nothing was recorded in that time.\",\"more_than_changes_in_that\":\"More than {0} changes in that time.\",\"ask_for_less\":\"Ask for less.\",\"ask_for_longer_ones\":\"Ask for longer ones.\",\"ask_for_a_shorter_one\":\"Ask for a shorter one.\",\"more_than_intervals\":\"More than {0} intervals.\",\"more_than_events_in_this\":\"More than {0} events in this period.\",\"from_lies_after_to\":\"from does not lie before to.\",\"exchange_them\":\"Exchange them.\",\"at_most_days_at_a\":\"At most {0} days at a time.\",\"parquet_needs_pyarrow\":\"Parquet needs pyarrow.\",\"pip_install_hoistway_parquet_or\":\"pip install 'hoistway[parquet]', or ask for CSV.\",\"is_no_moment_in_iso\":\"is no moment in ISO 8601, such as 2026-07-01T08:30:00Z\",\"is_no_moment_in_iso_2\":\"{0}: is no moment in ISO 8601, such as 2026-07-01T08:30:00Z\",\"out_of_service_needs_a\":\"Out of service needs a reason, in service has none.\",\"send_reason_with_in_service\":\"Send reason with in_service false only.\",\"vehicle_has_no_command\":\"Vehicle {0} has no command {1}.\",\"device_has_no_command\":\"Device {0} has no command {1}.\",\"job_id_stands_for_another\":\"Job id {0} stands for another order already: job {1}.\",\"idempotency_key_stands_for_another\":\"Idempotency-Key {0} stands for another order already: job {1}.\",\"send_the_same_body_as\":\"Send the same body as at first, or choose another id.\",\"idempotency_key_has_1_to\":\"Idempotency-Key has 1 to 128 printable ASCII characters without blanks.\",\"there_are\":\"There are {0}.\",\"after_is_the_number_of\":\"after is the number of an event.\",\"send_the_seq_of_the\":\"Send the seq of the last event seen.\",\"you_have_to_say_who\":\"You have to say who you are again.\",\"send_resync_true_topics_vehicles\":\"Send {\\\"resync\\\": true}, {\\\"topics\\\": [\\\"vehicles\\\"]} or {\\\"id\\\": 1, \\\"command\\\": {...}}.\",\"a_message_has_at_most\":\"A message has at most {0} characters.\",\"the_message_asks_for_nothing\":\"The message asks for nothing.\",\"the_message_is_not_understood\":\"The message is not understood: {0}\",\"the_body_came_as\":\"The body came as {0}.\",\"send_the_header_content_type\":\"Send the header Content-Type: {0}.\",\"send_the_header_content_type_2\":\"Send the header Content-Type: text/csv, or application/json.\",\"report_it_with_the_server\":\"Report it with the server's log of this moment; nothing is known of the request's effect.\",\"the_request_met_a_defect\":\"The request met a defect of this server.\",\"there_is_no_2\":\"There is no /{0}.\",\"the_paths_are_listed_at\":\"The paths are listed at /api/docs.\",\"does_not_have\":\"{0} does not have {1}.\",\"it_has_get\":\"It has GET{0}.\",\"it_has\":\"It has {0}.\",\"it_has_stopped\":\"It has stopped.\",\"there_is_no_stream_at\":\"There is no stream at {0}.\",\"the_live_stream_is_at\":\"The live stream is at /api/v1/live.\",\"the_body_is_not_json\":\"The body is not JSON.\",\"the_body_is_not_json_2\":\"The body is not JSON: {0}.\",\"there_is_no_such_field\":\"there is no such field\",\"a_body_in_json_is\":\"a body in JSON is required\",\"a_json_object_is_required\":\"a JSON object is required\",\"the_body_has_to_be\":\"the body has to be a JSON object\",\"is_required\":\"is required\",\"is_none_of\":\"is none of {0}\",\"holds_a_character_that_is\":\"holds a character that is not allowed here (control characters never are)\",\"there_is_no_such_field_2\":\"{0}: there is no such field\",\"a_json_object_is_required_2\":\"{0}: a JSON object is required\",\"is_required_2\":\"{0}: is required\",\"is_none_of_2\":\"{0}: is none of {1}\",\"holds_a_character_that_is_2\":\"{0}: holds a character that is not allowed here (control characters never are)\",\"input_should_be_a_valid\":\"{0}: Input should be a valid string\",\"input_should_be_a_valid_2\":\"{0}: Input should be a valid number\",\"input_should_be_a_valid_3\":\"{0}: Input should be a valid integer\",\"input_should_be_a_valid_4\":\"{0}: Input should be a valid number, unable to parse string as a number\",\"input_should_be_a_valid_5\":\"{0}: Input should be a valid integer, unable to parse string as an integer\",\"input_should_be_a_valid_6\":\"{0}: Input should be a valid boolean\",\"input_should_be_a_valid_7\":\"{0}: Input should be a valid list\",\"input_should_be_greater_than\":\"{0}: Input should be greater than {1}\",\"input_should_be_greater_than_2\":\"{0}: Input should be greater than or equal to {1}\",\"input_should_be_less_than\":\"{0}: Input should be less than {1}\",\"input_should_be_less_than_2\":\"{0}: Input should be less than or equal to {1}\",\"input_should_be\":\"{0}: Input should be '{1}'\",\"string_should_have_at_least\":\"{0}: String should have at least {1} character\",\"string_should_have_at_least_2\":\"{0}: String should have at least {1} characters\",\"string_should_have_at_most\":\"{0}: String should have at most {1} characters\",\"this_server_keeps_nobody_who\":\"This server keeps nobody who may log in.\",\"keep_the_plant_in_a\":\"Keep the plant in a database.\",\"nobody_has_to_log_in\":\"Nobody has to log in here, so nobody has.\",\"add_a_user_first_post\":\"Add a user first: POST /api/v1/users.\",\"commands_of_yours_are_under\":\"{0} commands of yours are under way.\",\"wait_for_their_replies\":\"Wait for their replies.\",\"did_you_mean\":\"Did you mean {0}?\",\"send_actor_name\":\"Send \\\"actor\\\": \\\"NAME\\\".\",\"this_command_has_no_body\":\"This command has no body.\",\"leave_it_out\":\"Leave it out.\",\"nothing_to_write_was_named\":\"Nothing to write was named.\",\"send_present_carrier_reserved_or\":\"Send present, carrier, reserved or out_of_service.\",\"vehicles_know_the_positions_of\":\"Vehicles know the positions of side buffers themselves.\",\"is_no_port_it_has\":\"{0} is no port: it has no DEST.\",\"it_has_versions_1_to\":\"It has versions 1 to {0}.\",\"it_was_never_taught\":\"It was never taught.\",\"has_no_version\":\"{0} has no version {1}.\",\"nothing_was_imported_of_rows\":\"Nothing was imported: {0} of {1} rows are wrong, the first on line {2}.\",\"correct_them_dry_run_true\":\"Correct them; dry_run=true shows every row.\",\"export_a_file_and_edit\":\"Export a file, and edit that.\",\"is_no_whole_number\":\"{0} is no whole number\",\"the_file_is_not_utf\":\"The file is not UTF-8.\",\"save_it_as_csv_in\":\"Save it as CSV in UTF-8.\",\"line_is_no_csv\":\"Line {0} is no CSV: {1}.\",\"the_first_line_names_the\":\"The first line names the columns: {0}, separated by commas.\",\"the_file_has_no_column\":\"The file has no column {0}.\",\"line_1_unknown_column\":\"Line 1: unknown column {0}\",\"did_you_mean_2\":\"did you mean {0}?\",\"known\":\"known: {0}\",\"a_column_stands_twice\":\"A column stands twice.\",\"keep_one_of_them\":\"Keep one of them.\",\"the_body_is_no_list\":\"The body is no list of rows.\",\"send_items_shft_0_rota\":\"Send {\\\"items\\\": [{\\\"{0}\\\": \\\"...\\\", \\\"shft\\\": 0, \\\"rota\\\": 0, \\\"lift\\\": 0}]}.\",\"the_file_has_more_than\":\"The file has more than {0} rows.\",\"there_is_no_column_here\":\"there is no column {0} here\",\"take_it_out\":\"take it out\",\"proposal_is_pending\":\"proposal {0} is pending: {1}\",\"proposal_is_ready\":\"proposal {0} is ready: {1}\",\"proposal_is_ambiguous\":\"proposal {0} is ambiguous: {1}\",\"proposal_is_approved\":\"proposal {0} is approved: {1}\",\"proposal_is_rejected\":\"proposal {0} is rejected: {1}\",\"proposal_is_collecting\":\"proposal {0} is collecting: {1}\",\"proposal_is_incomplete\":\"proposal {0} is incomplete: {1}\",\"proposal_is_out_of_range\":\"proposal {0} is out_of_range: {1}\",\"proposal_is_unusable\":\"proposal {0} is unusable: {1}\",\"proposal_is_wrong_mode\":\"proposal {0} is wrong_mode: {1}\",\"proposal_is_unknown_barcode\":\"proposal {0} is unknown_barcode: {1}\",\"close_it_its_port_or\":\"close it: its port or vehicle is not in the plant any more\",\"stands_at_needs_the_barcode\":\"stands_at needs the barcode, and only stands_at has one.\",\"send_barcode_with_stands_at\":\"Send barcode with stands_at, or leave it out.\",\"version_has_no_catalogue\":\"Version {0} has no catalogue {1}.\",\"version_is_active_not\":\"Version {0} is active, not {1}.\",\"look_at_what_differs_from\":\"Look at what differs from that one.\",\"see_errors_for_all_of\":\"See errors for all of it; end that first, or send wait: true.\",\"this_server_keeps_no_versions\":\"This server keeps no versions of the plant.\",\"start_it_with_hoistway_serve\":\"Start it with hoistway serve, on a database in a file or a server.\",\"the_plant_file_is_not\":\"The plant file is not UTF-8: {0} at byte {1}.\",\"save_it_as_utf_8\":\"Save it as UTF-8.\",\"stage_a_file_that_this\":\"Stage a file that this program understands.\",\"version_cannot_be_used_by\":\"Version {0} cannot be used by this program: {1}.\",\"the_text_of_version_is\":\"The text of version {0} is not kept any more; it was rejected: {1}.\",\"stage_it_again_if_somebody\":\"Stage it again, if somebody has it and it is wanted after all.\",\"the_plant_file_has_error\":\"The plant file has {0} error; line {1}, column {2}: {3}.\",\"the_plant_file_has_errors\":\"The plant file has {0} errors; line {1}, column {2}: {3}.\",\"correct_the_plant_file_and\":\"Correct the plant file, and look at it with hoistway check.\",\"there_is_no_event\":\"there is no event {0}\",\"nothing_may_be_sent_there\":\"Nothing may be sent there: {0}.\",\"there_is_no_user\":\"There is no user {0}.\",\"there_is_no_key\":\"There is no key {0}.\",\"there_is_no_job\":\"There is no job {0}.\",\"there_is_no_vehicle_2\":\"There is no vehicle {0}.\",\"there_is_no_station_2\":\"There is no station {0}.\",\"there_is_no_carrier_2\":\"There is no carrier {0}.\",\"there_is_no_device_2\":\"There is no device {0}.\",\"there_is_no_drive_2\":\"There is no drive {0}.\",\"there_is_no_link\":\"There is no link {0}.\",\"there_is_no_zone_2\":\"There is no zone {0}.\",\"there_is_no_alarm_2\":\"There is no alarm {0}.\",\"there_is_no_closure\":\"There is no closure {0}.\",\"there_is_no_walk\":\"There is no walk {0}.\",\"there_is_no_operation\":\"There is no operation {0}.\",\"there_is_no_backup\":\"There is no backup {0}.\",\"there_is_no_webhook_2\":\"There is no webhook {0}.\",\"there_is_no_problem\":\"There is no problem {0}.\",\"there_is_no_controller\":\"There is no controller {0}.\",\"there_is_no_proposal\":\"There is no proposal {0}.\",\"there_is_no_teaching_session\":\"There is no teaching session {0}.\",\"there_is_no_parameter\":\"There is no parameter {0}.\",\"there_is_no_time_zone\":\"There is no time zone {0}.\",\"such_as_asia_seoul\":\"Such as Asia/Seoul, Europe/Berlin or UTC.\",\"this_machine_has_no_time_zones\":\"This machine has no time zones.\",\"pip_install_tzdata\":\"pip install tzdata, or leave tz out.\",\"from_lies_in_the_future\":\"from lies in the future.\",\"a_period_up_to_now\":\"It is a period up to now, unless to is said.\",\"there_are_none_here\":\"There are none here.\",\"is_given_more_than_once\":\"{0} is given more than once.\",\"give_it_once\":\"Give it once.\",\"there_is_no_language\":\"There is no language {0}.\",\"this_command_is_about_one\":\"This command is about one object.\",\"send_its_id_as_target\":\"Send its id as \\\"target\\\".\",\"ask_for_a_period_that_has\":\"Ask for a period that has begun.\",\"there_is_no_event_yet\":\"There is no event {0} yet: the newest is {1}.\",\"if_the_database_is_another\":\"If the database is another one than before, begin with after=0.\",\"there_is_no_topic\":\"There is no topic {0}.\",\"there_is_no_command\":\"There is no command {0}.\",\"there_is_no_version\":\"There is no version {0}.\",\"there_is_no_version_of\":\"There is no version {0} of the plant.\",\"it_has_not_reported_yet\":\"it has not reported yet\",\"wait_for_it\":\"wait for it\",\"is_an_agv_and_enig\":\"{0} is an AGV, and ENIG has no display\",\"is_an_agv_and_enig_2\":\"{0} is an AGV, and ENIG has no such command\",\"it_stands_or_is_about\":\"it stands, or is about to\",\"stopped_before_it_set_out\":\"stopped before it set out\",\"stopped_on_its_way\":\"stopped on its way\",\"may_choose_another_way_from\":\"{0} may choose another way from {1} to {2} than the one granted\",\"correct_the_lengths_of_the\":\"correct the lengths of the track there, or make one of the ways one-way\",\"status_does_not_show_it\":\"Status does not show it in position at {0}, but at {1}\",\"its_lift_is_up_and\":\"its lift is up, and {0}\",\"its_lift_is_down_and\":\"its lift is down, and {0}\",\"its_lift_is_unknown_and\":\"its lift is unknown, and {0}\",\"no_cart_is_on_it\":\"no cart is on it\",\"a_cart_is_on_it\":\"a cart is on it\",\"it_does_not_know_whether\":\"it does not know whether a cart is on it\",\"has_its_lift_neither_up\":\"has its lift neither up nor down: wait for it, or send agv_lift up or down\",\"does_not_know_whether_a\":\"does not know whether a cart is on it: see, and set that right at the AGV\",\"moves_taken_255_is_followed\":\"moves taken, 255 is followed by 1\",\"none_yet\":\"none yet\",\"the_device_reports_no_more\":\"the device reports no more\",\"another_command_was_sent_before\":\"another command was sent before this one showed its effect\",\"over_current_second_level\":\"over-current, second level\",\"over_current\":\"over-current\",\"overheated\":\"overheated\",\"over_voltage\":\"over-voltage\",\"under_voltage\":\"under-voltage\",\"braking_transistor\":\"braking transistor\",\"overload\":\"overload\",\"overload_second_level\":\"overload, second level\",\"cb0_look_it_up_in\":\"CB0: look it up in the drive's manual\",\"cb1_look_it_up_in\":\"CB1: look it up in the drive's manual\",\"cb2_look_it_up_in\":\"CB2: look it up in the drive's manual\",\"se_look_it_up_in\":\"SE: look it up in the drive's manual\",\"communication_error\":\"communication error\",\"mark_sensor\":\"mark sensor\",\"home_search_failed\":\"home search failed\",\"external_error_input\":\"external error input\",\"not_in_the_specification\":\"not in the specification\",\"01_oc2_over_current_second\":\"01 OC2: over-current, second level\",\"02_oc_over_current\":\"02 OC: over-current\",\"03_oh_overheated\":\"03 OH: overheated\",\"04_ov_over_voltage\":\"04 OV: over-voltage\",\"05_uv_under_voltage\":\"05 UV: under-voltage\",\"06_btr_braking_transistor\":\"06 BTR: braking transistor\",\"07_ol1_overload\":\"07 OL1: overload\",\"08_ol2_overload_second_level\":\"08 OL2: overload, second level\",\"09_cb0_cb0_look_it\":\"09 CB0: CB0: look it up in the drive's manual\",\"10_cb1_cb1_look_it\":\"10 CB1: CB1: look it up in the drive's manual\",\"11_cb2_cb2_look_it\":\"11 CB2: CB2: look it up in the drive's manual\",\"12_com_err_communication_error\":\"12 COM_ERR: communication error\",\"13_mark_err_mark_sensor\":\"13 MARK_ERR: mark sensor\",\"14_home_err_home_search\":\"14 HOME_ERR: home search failed\",\"15_se_se_look_it\":\"15 SE: SE: look it up in the drive's manual\",\"16_ext_err_external_error\":\"16 EXT_ERR: external error input\",\"look_for_a_short_circuit\":\"look for a short circuit in motor and cable, then press Stop/Reset\",\"look_for_a_jammed_axis\":\"look for a jammed axis, or lengthen the acceleration, then press Stop/Reset\",\"let_it_cool_see_to\":\"let it cool, see to its fan and its load, then press Stop/Reset\",\"lengthen_the_deceleration_or_see\":\"lengthen the deceleration, or see to the brake resistor and the mains, then press Stop/Reset\",\"see_to_the_mains_and\":\"see to the mains and its fuses, then press Stop/Reset\",\"see_to_the_brake_resistor\":\"see to the brake resistor, lengthen the deceleration, then press Stop/Reset\",\"free_the_axis_or_lessen\":\"free the axis, or lessen its load, then press Stop/Reset\",\"free_the_axis_let_the\":\"free the axis, let the motor cool, then press Stop/Reset\",\"remove_its_cause_then_press\":\"remove its cause, then press Stop/Reset\",\"see_to_the_cable_and\":\"see to the cable and the drive's id and speed of transmission, then press Stop/Reset\",\"clean_and_align_the_mark\":\"clean and align the mark sensor, then press Stop/Reset\",\"see_to_the_home_sensor\":\"see to the home sensor and the way to it, then press Stop/Reset and search home again\",\"remove_what_sets_the_external\":\"remove what sets the external input, then press Stop/Reset\",\"look_it_up_in_the\":\"look it up in the drive's manual, then press Stop/Reset\",\"epoch_is_outside_1\":\"epoch {0} is outside 1..{1}\",\"the_cmd_id_counter_of\":\"the CMD_ID counter of this epoch is used up: restart the controller\",\"there_is_no_port_to\":\"there is no port {0} to write\",\"there_is_no_hoist_to\":\"there is no hoist {0} to write\",\"is_on_line_already\":\"{0} is on line {1} already\",\"keep_one_of_them_2\":\"keep one of them\",\"is_at_version_now_not\":\"{0} is at version {1} now, not {2}\",\"export_again_then_edit\":\"export again, then edit\",\"has_no_value\":\"{0} has no value\",\"give_shft_rota_and_lift\":\"give shft, rota and lift, or those that change\",\"stay_unknown_jobs_stay_refused\":\"{0} stay unknown: jobs stay refused\",\"shft_is_outside_2\":\"SHFT {0} is outside {1}..{2}\",\"rota_is_outside_2\":\"ROTA {0} is outside {1}..{2}\",\"lift_is_outside_2\":\"LIFT {0} is outside {1}..{2}\",\"closed_for_people_at_work_2\":\"closed for people at work\",\"a_path_has_at_least\":\"a path has at least one element, and its last is a stop\",\"seq_to_is_outside_0\":\"SEQ {0} to {1} is outside 0..{2}\",\"no_route_from_to\":\"no route from {0} to {1}\",\"no_route_from_to_is_3\":\"no route from {0} to {1}: {2} is not on the track\",\"no_route_from_to_the\":\"no route from {0} to {1}: the track does not connect them\",\"open_to\":\"open {0} to {1}\",\"this_controller_has_stopped\":\"This controller has stopped.\",\"ask_the_one_that_holds\":\"Ask the one that holds the plant now, or start it again.\",\"the_plant_was_changed_meanwhile\":\"the plant was changed meanwhile: version {0} is active, not {1}\",\"the_plant_was_changed_meanwhile_2\":\"the plant was changed meanwhile: none is active, not {0}\",\"start_again\":\"Start again.\",\"a_defect_stopped_the_controller\":\"a defect stopped the controller; see the log\",\"the_lease_on_the_plant\":\"the lease on the plant ran out while this process stood still or the database was away\",\"a_newer_hoistway_has_written\":\"a newer Hoistway has written this file\",\"open_it_with_that_one\":\"Open it with that one.\",\"this_is_no_recorded_incident\":\"this is no recorded incident: {0}\",\"get_one_with_get_api\":\"Get one with GET /api/v1/history/export.\",\"it_sent_more_than_bytes\":\"it sent more than {0} bytes in a second\",\"the_connection_was_closed\":\"the connection was closed\",\"is_not_the_address_of\":\"{0} is not the address of any vehicle that may dial in\",\"claims_to_be_which_is\":\"{0} claims to be {1}, which is connected already\",\"connections_are_being_asked_who\":\"{0} connections are being asked who they are already\",\"has_dev_id_which_no\":\"{0} has DEV_ID {1}, which no vehicle that may come from there has\",\"answers_to_no_id_that\":\"{0} answers to no id that is missing\",\"nothing_was_made_durable_or\":\"nothing was made durable or tried for {0} s\",\"a_password_has_to_characters\":\"A password has {0} to {1} characters.\",\"no_folder_for_temporary_files\":\"no folder for temporary files\",\"is_no_person_who_logged\":\"{0} is no person who logged in.\",\"a_key_is_good_until\":\"A key is good until it expires.\",\"delete_api_v1_keys_name\":\"DELETE /api/v1/keys/NAME ends a key.\",\"log_in_with_name_and\":\"Log in with name and password.\",\"this_is_a_recording\":\"This is a recording.\",\"ask_the_controller_of_the\":\"Ask the controller of the plant itself.\",\"a_recording\":\"a recording\",\"traces_are_wanted_and_is\":\"traces are wanted, and {0} is not installed\",\"install_hoistway_otel_or_leave\":\"Install hoistway[otel], or leave traces off.\",\"no_answer_in_s\":\"no answer in {0} s\",\"no_answer_within_s\":\"no answer within {0} s\",\"it_is_a_file_of\":\"It is a file of the plant {0}, and this is {1}.\",\"write_name_into_it_if\":\"Write name: {0} into it, if it is meant for this plant.\",\"says_that_it_is_gone\":\"says that it is gone for good (410)\",\"has_not_taken_event_for\":\"has not taken event {0} for {1} h ({2})\",\"events_to_are_no_longer\":\"events {0} to {1} are no longer kept\",\"name_the_host_domain_address\":\"Name the host, *.domain, address or network in HOISTWAY_WEBHOOK_TARGETS, or as webhook_targets in the settings file, and start the controller again.\",\"set_hoistway_webhook_targets_or\":\"set HOISTWAY_WEBHOOK_TARGETS, or webhook_targets in the settings file\",\"write_a_url_of_http\":\"Write a URL of http or https, without a name, a password or a fragment.\",\"it_is_no_url\":\"it is no URL: {0}\",\"it_is_no_url_of\":\"it is no URL of http or https\",\"a_url_with_a_name\":\"a URL with a name or password in it would stand in logs\",\"a_fragment_is_never_sent\":\"a fragment is never sent\",\"this_server_may_send_to\":\"this server may send to nobody\",\"is_not_among_the_targets\":\"{0} is not among the targets that are allowed\",\"leads_to_which_is_not\":\"{0} leads to {1}, which is not allowed\",\"leads_to_no_address_which\":\"{0} leads to no address, which is not allowed\",\"webhook_targets_is_no_host\":\"webhook_targets: {0} is no host, address or network\",\"write_such_as_mes_fab\":\"Write such as mes.fab, mes.fab:8443, *.fab, 10.1.2.3 or 10.0.0.0/8.\",\"the_thread_that_writes_the\":\"the thread that writes the database broke; see the log\",\"a_database_in_memory_keeps\":\"a database in memory keeps nobody who may log in\",\"a_database_in_memory_keeps_2\":\"a database in memory keeps no versions of the plant\",\"a_database_in_memory_can\":\"a database in memory can be read by its ledger alone\",\"a_database_in_memory_cannot\":\"a database in memory cannot be put back\",\"keep_the_plant_in_a_2\":\"Keep the plant in a file.\",\"write_sqlite_var_plant_db\":\"Write sqlite:///var/plant.db.\",\"write_sqlite_var_plant_db_2\":\"Write sqlite:///var/plant.db or postgresql://user@host/database.\",\"key_is_revoked_already\":\"Key {0} is revoked already.\",\"nothing_more_has_to_be\":\"Nothing more has to be done.\",\"nothing_has_to_be_done\":\"Nothing has to be done.\",\"choose_another_name_none_is\":\"Choose another name: none is used twice, so that the audit can be read for years.\",\"there_is_a_user_already\":\"There is a user {0} already.\",\"there_is_a_key_already\":\"There is a key {0} already.\",\"make_somebody_else_an_administrator\":\"Make somebody else an administrator first: hoistway users add NAME --role admin.\",\"users_and_keys_cannot_be\":\"users and keys cannot be read: {0}\",\"a_password_cannot_be_kept\":\"a password cannot be kept: {0}\",\"the_session_cannot_be_renewed\":\"the session cannot be renewed: {0}\",\"the_use_of_keys_cannot\":\"the use of keys cannot be kept: {0}\",\"the_change_cannot_be_kept\":\"the change cannot be kept: {0}\",\"the_audit_cannot_be_written\":\"the audit cannot be written: {0}\",\"there_is_no_database\":\"there is no database {0}\",\"see_url\":\"See --url.\",\"see_url_and_the_file\":\"See --url and the file.\",\"there_is_no_backup_2\":\"there is no backup {0}\",\"name_a_file_that_hoistway\":\"Name a file that hoistway db backup has written.\",\"is_no_backup_of_a\":\"{0} is no backup of a plant: {1}\",\"is_damaged\":\"{0} is damaged: {1}\",\"take_an_earlier_backup\":\"Take an earlier backup.\",\"is_the_database_itself\":\"{0} is the database itself\",\"name_the_backup\":\"Name the backup.\",\"the_lease_of_the_plant\":\"the lease of the plant cannot be renewed: {0}\",\"the_lease_of_the_plant_2\":\"the lease of the plant cannot be taken: {0}\",\"the_lease_cannot_be_renewed\":\"the lease cannot be renewed: {0}\",\"bring_it_up_to_date\":\"Bring it up to date: hoistway db upgrade.\",\"there_is_nothing_to_keep\":\"There is nothing to keep yet.\",\"the_database_has_schema_not\":\"the database has schema {0}, not {1}\",\"the_database_has_schema_none\":\"the database has schema none, not {0}\",\"the_database_cannot_be_opened\":\"the database cannot be opened: {0}\",\"the_database_cannot_be_read\":\"the database cannot be read: {0}\",\"the_database_cannot_be_read_2\":\"the database cannot be read: its schema is {0}, not {1}\",\"the_database_cannot_be_read_3\":\"the database cannot be read: it holds no plant\",\"the_database_cannot_be_copied\":\"the database cannot be copied: {0}\",\"the_database_cannot_be_finished\":\"the database cannot be finished: {0}\",\"the_database_keeps_plant_the\":\"the database keeps plant {0}, the backup plant {1}\",\"the_database_keeps_plant_not\":\"the database keeps plant {0}, not {1}\",\"the_backup_cannot_be_prepared\":\"the backup cannot be prepared in {0}: {1}\",\"the_backup_cannot_be_put\":\"the backup cannot be put back: {0}\",\"cannot_be_copied\":\"{0} cannot be copied: {1}\",\"see_that_the_disk_has\":\"See that the disk has room.\",\"keeps_no_plant\":\"{0} keeps no plant\",\"exists_already\":\"{0} exists already\",\"a_backup_does_not_replace\":\"A backup does not replace another one: give it a new name.\",\"see_that_the_directory_exists\":\"See that the directory exists, that this user may write in it, and that the disk has room.\",\"cannot_be_written\":\"{0} cannot be written: {1}\",\"another_program_has_the_database\":\"another program has the database open\",\"close_it_then_try_again\":\"Close it, then try again.\",\"is_not_the_url_of\":\"{0} is not the URL of a database\",\"is_not_a_database_that\":\"{0} is not a database that Hoistway keeps a plant in\",\"make_room_on_the_disk\":\"Make room on the disk.\",\"give_this_user_the_right\":\"Give this user the right to write the file and its directory.\",\"see_that_the_directory_exists_2\":\"See that the directory exists and that this user may write in it.\",\"the_file_is_damaged_put\":\"The file is damaged: put a backup back with hoistway db restore.\",\"name_another_file_or_remove\":\"Name another file, or remove this one if nothing needs it.\",\"another_program_is_writing_to\":\"Another program is writing to the file; close it.\",\"see_that_the_database_server\":\"See that the database server runs and can be reached.\",\"restart_it_it_then_finds\":\"Restart it: it then finds out what happened meanwhile before it sends anything.\",\"cannot_open\":\"cannot open {0}: {1}\",\"is_held_by_a_controller\":\"{0} is held by a controller that gave no name\",\"was_removed_another_controller_may\":\"{0} was removed: another controller may have taken the plant\",\"was_removed_another_controller_may_2\":\"{0} was removed: another controller may have taken the plant. Restart it: it then finds out what happened meanwhile before it sends anything.\",\"this_controller_was_stopped_or\":\"this controller was stopped, or cut off from the database, for longer than {0} s: its lease of the plant has run out\",\"this_controller_was_stopped_or_2\":\"this controller was stopped, or cut off from the database, for longer than {0} s: its lease of the plant has run out. Restart it: it then finds out what happened meanwhile before it sends anything.\",\"plant_is_held_by_since\":\"plant {0} is held by {1}, since {2}\",\"stop_that_controller_first_or\":\"Stop that controller first, or give this one a database of its own.\",\"what_is_kept_cannot_be\":\"what is kept cannot be read: {0}\",\"the_ledger_is_not_loaded\":\"the ledger is not loaded: what is kept must be known before anything is added\",\"old_events_cannot_be_deleted\":\"old events cannot be deleted: {0}\",\"give_each_plant_a_database\":\"Give each plant a database of its own, or write the plant's old name into the plant file.\",\"the_records_cannot_be_kept\":\"the records cannot be kept: {0}\",\"another_controller_has_started_on\":\"another controller has started on the database of plant {0}\",\"stop_one_of_them_this\":\"Stop one of them; this one sends nothing more.\",\"another_controller_has_started_on_2\":\"another controller has started on the database of plant {0}. Stop one of them; this one sends nothing more.\",\"the_playback_store_cannot_be\":\"the playback store cannot be opened: {0}\",\"the_playback_store_cannot_be_2\":\"the playback store cannot be read: {0}\",\"playback_cannot_be_kept\":\"playback cannot be kept: {0}\",\"old_playback_cannot_be_deleted\":\"old playback cannot be deleted: {0}\",\"there_is_no_row\":\"there is no row {0}\",\"the_version_of_the_database\":\"the version of the database cannot be read: {0}\",\"the_database_is_in_use\":\"the database is in use for something else: it has a table {0}, and no version\",\"give_hoistway_a_database_postgresql\":\"Give Hoistway a database (PostgreSQL: or a schema) of its own.\",\"the_database_has_schema_written\":\"the database has schema {0}, written by a newer Hoistway; this one knows schemas up to {1}\",\"run_the_newer_hoistway_or\":\"Run the newer Hoistway, or restore a backup made before its first start.\",\"the_tables_of_the_database\":\"the tables of the database cannot be made: {0}\",\"start_the_controller_on_it\":\"Start the controller on it once.\",\"a_record_cannot_be_kept\":\"a record cannot be kept: {0}: {1}\",\"the_versions_of_the_plant\":\"the versions of the plant cannot be read: {0}\",\"the_versions_of_the_plant_2\":\"the versions of the plant cannot be kept: {0}\",\"another_controller_has_begun_on\":\"another controller has begun on the database meanwhile\",\"version_is_the_active_one\":\"Version {0} is the active one.\",\"stage_its_text_again_if\":\"Stage its text again, if it is wanted after all.\",\"version_is_rejected\":\"Version {0} is rejected: {1}\",\"wait_for_it_or_post\":\"Wait for it, or POST /api/v1/layout/versions/{0}/reject.\",\"version_is_to_become_active\":\"Version {0} is to become active already.\",\"only_what_is_staged_or\":\"Only what is staged or awaited can be rejected.\",\"version_is_active\":\"Version {0} is active.\",\"version_is_former\":\"Version {0} is former.\",\"version_is_rejected_2\":\"Version {0} is rejected.\",\"version_of_the_plant_is\":\"version {0} of the plant is not wanted any more\",\"reject_what_nobody_wants_any\":\"Reject what nobody wants any more: POST /api/v1/layout/versions/N/reject.\",\"versions_are_staged_already\":\"{0} versions are staged already.\",\"that_is_the_active_version\":\"That is the active version {0}, to the letter.\",\"activate_that_one_post_api\":\"Activate that one: POST /api/v1/layout/versions/{0}/activate.\",\"that_is_version_staged_to\":\"That is version {0} (staged), to the letter.\",\"that_is_version_former_to\":\"That is version {0} (former), to the letter.\",\"from_1\":\"from ::1\",\"from_2\":\"from {0}:{1}:{2}:{3}\",\"that_is_version_awaited_to\":\"That is version {0} (awaited), to the letter.\",\"no_route_from_to_2\":\"no route from {0} to {1}: {2}\",\"shft_is_outside_of_2\":\"SHFT {0} is outside {1}..{2} of {3}\",\"rota_is_outside_of_2\":\"ROTA {0} is outside {1}..{2} of {3}\",\"lift_is_outside_of_2\":\"LIFT {0} is outside {1}..{2} of {3}\",\"shft_for_is_outside_of_2\":\"SHFT {0} for {1} is outside {2}..{3} of {4}\",\"rota_for_is_outside_of_2\":\"ROTA {0} for {1} is outside {2}..{3} of {4}\",\"lift_for_is_outside_of_2\":\"LIFT {0} for {1} is outside {2}..{3} of {4}\",\"is_not_connected_3\":\"{0} is not connected: \",\"line\":\"line {0}: {1}\",\"place_to_reason_purpose_traffic\":\"place {0} to {1}, reason {2}, purpose traffic\",\"place_to_reason_purpose_traffic_2\":\"place {0} to {1}, reason {2}, purpose traffic, expires {3}\",\"place_to_reason_purpose_work\":\"place {0} to {1}, reason {2}, purpose work\",\"place_zone_reason_purpose_traffic\":\"place zone {0}, reason {1}, purpose traffic\",\"place_zone_reason_purpose_traffic_2\":\"place zone {0}, reason {1}, purpose traffic, expires {2}\",\"place_zone_reason_purpose_work\":\"place zone {0}, reason {1}, purpose work\",\"is_held_by_for_plant\":\"{0} is held by {1}, for plant {2}, since {3}\",\"there_is_no_event_did\":\"there is no event {0}; did you mean {1}?\",\"no_route_from_to_to_2\":\"no route from {0} to {1}: {2} to {3} is closed\",\"barcode_is_given_twice_the\":\"barcode {0} is given twice: the first time on line {1}\",\"keep_one\":\"keep one\",\"barcode_is_not_1_to\":\"barcode {0} is not 1 to 16 visible ASCII characters\",\"is_a_range_so_it\":\"{0} is a range, so it needs two ends\",\"write_from_x_y_to\":\"write {from: [x, y], to: [x, y]}\",\"is_one_barcode_so_it\":\"{0} is one barcode, so it has one position\",\"write_x_y_or_a\":\"write [x, y], or a range as the key\",\"is_no_range_of_barcodes\":\"{0} is no range of barcodes: write it as 1001..1020 or A01..A20\",\"the_ends_of_have_different\":\"the ends of {0} have different numbers of digits\",\"has_more_than_barcodes\":\"{0} has more than {1} barcodes\",\"is_no_address_write_host\":\"{0} is no address: write HOST:PORT, such as 10.0.0.17:9000\",\"is_no_address_write_host_2\":\"'{0}' is no address: write HOST:PORT, such as 10.0.0.17:9000\",\"port_is_outside_1_65535\":\"port {0} is outside 1..65535\",\"track_through_alone_leads_nowhere\":\"track through {0} alone leads nowhere\",\"name_at_least_two_barcodes\":\"name at least two barcodes\",\"track_leads_from_to_itself\":\"track leads from {0} to itself\",\"name_it_once\":\"name it once\",\"track_is_given_twice_the\":\"track {0} → {1} is given twice: the first time on line {2}\",\"track_has_length_0_both\":\"track {0} → {1} has length 0: both lie at [{2}, {3}]\",\"move_one\":\"move one\",\"track_is_mm_long_but\":\"track {0} → {1} is {2} mm long, but its ends are {3} mm apart\",\"correct_the_length_or_the\":\"correct the length or the positions\",\"correct_it_or_mark_it\":\"correct it, or mark it with curve: true\",\"does_not_fit_the_vehicle\":\"{0} does not fit the vehicle's display: {1} ASCII characters\",\"does_not_fit_the_vehicle_2\":\"'{0}' does not fit the vehicle's display: {1} ASCII characters\",\"give_a_shorter_name_with\":\"give a shorter name with display:\",\"cannot_be_its_own_fallback\":\"{0} cannot be its own fallback\",\"is_no_port_a_vehicle\":\"{0} is no port: a vehicle knows its positions there, so dest is not used\",\"leave_it_out_2\":\"leave it out\",\"give_it_under_buffers\":\"give it under buffers\",\"unknown_buffer\":\"unknown buffer {0}\",\"has_the_same_buffer_as\":\"{0} has the same buffer as {1}: {2}\",\"each_needs_its_own\":\"each needs its own\",\"zone_is_soft_and_no\":\"zone {0} is soft and no_stop\",\"leave_out_one_of_them\":\"leave out one of them\",\"zone_has_a_share_or\":\"zone {0} has a share or a patience, and is not soft: they count for nothing\",\"add_soft_true\":\"add soft: true\",\"carrier_does_not_fit_the\":\"carrier {0} does not fit the vehicle's display: {1} characters\",\"holds_already_one_carrier_a\":\"{0} holds {1} already: one carrier a station\",\"choose_another\":\"choose another\",\"has_no_port\":\"{0} has no port\",\"write_host_port\":\"write HOST:PORT\",\"is_no_code_from_0\":\"{0} is no code from 0 to 65535 (0xFFFF)\",\"is_no_code_from_0_2\":\"'{0}' is no code from 0 to 65535 (0xFFFF)\",\"code_is_given_twice\":\"code {0} is given twice\",\"the_catalogue\":\"the catalogue\",\"the_plant_file\":\"the plant file\",\"and_are_both_called\":\"{0} and {1} are both called {2}\",\"people_will_take_one_for\":\"people will take one for the other\",\"is_no_parameter_number\":\"{0} is no parameter number\",\"is_no_parameter_number_2\":\"'{0}' is no parameter number\",\"write_two_hexadecimal_digits_in\":\"write two hexadecimal digits in quotes, such as \\\"1C\\\"\",\"the_scale_of_is_not\":\"the scale of {0} is not above 0\",\"it_is_what_one_raw\":\"it is what one raw step is worth\",\"min_of_is_above_its\":\"min {0} of {1} is above its max {2}\",\"swap_them\":\"swap them\",\"the_default_of_is_not\":\"the default of {0} is not from {1} to {2}\",\"is_read_only_so_it\":\"{0} is read-only, so it is not written while running\",\"min_lies_between_two_steps\":\"min {0} lies between two steps of {1}\",\"max_lies_between_two_steps\":\"max {0} lies between two steps of {1}\",\"default_lies_between_two_steps\":\"default {0} lies between two steps of {1}\",\"write_or_another_scale\":\"write {0}, or another scale\",\"is_on_the_wire_which\":\"{0} {1} is {2} on the wire, which carries 0 to {3}\",\"check_the_value_and_the\":\"check the value and the scale\",\"choice_is_no_raw_value\":\"choice {0} is no raw value from {1} to {2}\",\"choices_are_named_by_raw\":\"choices are named by raw values\",\"the_plant_has_no_vehicle\":\"the plant has no vehicle\",\"give_at_least_one_under\":\"give at least one under vehicles\",\"the_plant_has_no_station\":\"the plant has no station\",\"give_at_least_two_under\":\"give at least two under stations\",\"numbers_up_to_without_leading\":\"numbers up to {0}, without leading zeros\",\"at_most_characters\":\"at most {0} characters\",\"barcode_does_not_fit_dialect\":\"barcode {0} does not fit dialect {1} of {2}: it takes {3}\",\"barcode_and_more_do_not\":\"barcode {0} and {1} more do not fit dialect {2} of {3}: it takes {4}\",\"correct_the_barcode_or_the\":\"correct the barcode or the vehicle's dialect\",\"barcode_is_no_tag_that\":\"barcode {0} is no tag that an AGV reads: four printable ASCII characters\",\"barcode_and_more_are_no\":\"barcode {0} and {1} more are no tag that an AGV reads: four printable ASCII characters\",\"write_it_as_four_digits\":\"write it as four digits, such as 0042\",\"track_is_mm_long_can\":\"track {0} → {1} is {2} mm long; {3} can be told {4}\",\"put_a_barcode_between_dist\":\"put a barcode between (DIST_NEXT has 16 bits)\",\"s_dev_id_is_0\":\"{0}'s dev_id is 0, which vehicles without a number send\",\"number_vehicles_from_1\":\"number vehicles from 1\",\"limits_to\":\"{0} ({1}, limits {2} to {3})\",\"limits_to_and_more\":\"{0} ({1}, limits {2} to {3}) and {4} more\",\"s_target_is_beyond_the\":\"{0}'s {1} target is beyond the limits of {2}\",\"correct_dest_or_the_vehicle\":\"correct dest, or the vehicle's limits or offset\",\"there_are_parking_places_for\":\"there are {0} parking places for {1} vehicles in service\",\"add_barcodes_to_parking_best\":\"add barcodes to parking, best ones that no route needs\",\"starts_at_which_at_covers\":\"{0} starts at {1}, which {2} at {3} covers ({4} mm long)\",\"start_one_of_them_elsewhere\":\"start one of them elsewhere\",\"starts_mm_from_the_plant\":\"{0} starts {1} mm from {2}; the plant's clearance is {3} mm\",\"vehicles_start_in_zone_which\":\"{0} vehicles start in zone {1}, which holds {2}\",\"start_some_of_them_elsewhere\":\"start some of them elsewhere\",\"starts_in_zone_where_no\":\"{0} starts in zone {1}, where no vehicle may stop\",\"start_it_elsewhere\":\"start it elsewhere\",\"is_a_parking_place_in\":\"{0} is a parking place in zone {1}, where no vehicle may stop\",\"take_it_out_of_one\":\"take it out of one of them\",\"the_track_falls_into_pieces\":\"the track falls into {0} pieces with stations; {1} is not connected to {2}\",\"no_transfer_is_possible_from\":\"no transfer is possible from one to the other\",\"no_track_touches_barcode\":\"no track touches barcode {0}\",\"name_it_under_track_or\":\"name it under track, or leave it out\",\"dead_end_track_leads_to\":\"dead end: track leads to {0}, but none leads on\",\"add_track_from_it_or\":\"add track from it, or end the track before it\",\"no_track_leads_to_a\":\"no track leads to {0}: a vehicle can leave it, but never return\",\"add_track_to_it\":\"add track to it\",\"starts_at_on_a_piece\":\"{0} starts at {1}, on a piece of track without stations\",\"start_it_on_track_that\":\"start it on track that has stations\",\"is_the_only_station_on\":\"{0} is the only station on its piece of track: no transfer can begin or end there\",\"connect_it_to_other_stations\":\"connect it to other stations\",\"starts_at_from_where_no\":\"{0} starts at {1}, from where no way leads to station {2}\",\"start_it_elsewhere_or_add\":\"start it elsewhere, or add the missing track\",\"check_the_direction_of_the\":\"check the direction of the track around it\",\"at_cannot_be_reached_from\":\"{0} at {1} cannot be reached from {2}\",\"at_has_no_way_to\":\"{0} at {1} has no way to {2}\",\"track_leads_into_the_loop\":\"track leads into the loop of {0} and {1} more barcodes, but none leads out\",\"add_track_out_of_it\":\"add track out of it\",\"the_plant_file_has_no\":\"the plant file has no {0}\",\"the_catalogue_has_no\":\"the catalogue has no {0}\",\"has_no_at\":\"{0} has no at\",\"has_no_link\":\"{0} has no link\",\"has_no_number\":\"{0} has no number\",\"has_no_through\":\"{0} has no through\",\"has_no_id\":\"{0} has no id\",\"has_no_lift\":\"{0} has no lift\",\"has_no_rota\":\"{0} has no rota\",\"has_no_shft\":\"{0} has no shft\",\"has_no_protocol\":\"{0} has no protocol\",\"has_no_max\":\"{0} has no max\",\"has_no_min\":\"{0} has no min\",\"has_no_name\":\"{0} has no name\",\"has_no_device\":\"{0} has no device\",\"has_no_kind\":\"{0} has no kind\",\"has_no_from\":\"{0} has no from\",\"has_no_to\":\"{0} has no to\",\"has_no_dev_id\":\"{0} has no dev_id\",\"has_no_barcodes\":\"{0} has no barcodes\",\"add\":\"add {0}: {1}\",\"known_here\":\"known here: {0}\",\"unknown_key\":\"unknown key {0}\",\"unknown_key_in\":\"unknown key {0} in {1}\",\"give_at_least\":\"give at least {0}\",\"expected_got\":\"{0}: expected {1}, got {2}\",\"expected_got_nothing\":\"{0}: expected {1}, got nothing\",\"expected_text_got\":\"{0}: expected text, got {1}\",\"expected_text_got_nothing\":\"{0}: expected text, got nothing\",\"the_plant_file_expected_got\":\"the plant file: expected {0}, got {1}\",\"the_plant_file_expected_got_2\":\"the plant file: expected {0}, got nothing\",\"the_catalogue_expected_got\":\"the catalogue: expected {0}, got {1}\",\"the_catalogue_expected_got_nothing\":\"the catalogue: expected {0}, got nothing\",\"write_it_in_quotes\":\"write it in quotes\",\"write_the_number_alone_a\":\"write the number alone: a whole number of {0}\",\"true_or_false\":\"true or false\",\"a_whole_number\":\"a whole number\",\"a_whole_number_from_to\":\"a whole number from {0} to {1}\",\"a_whole_number_of_from\":\"a whole number of {0} from {1} to {2}\",\"a_whole_number_of_path\":\"a whole number of path elements from {0} to {1}\",\"a_whole_number_of_transfers\":\"a whole number of transfers from {0} to {1}\",\"a_whole_number_of_vehicles\":\"a whole number of vehicles from {0} to {1}\",\"a_whole_number_of_pulses\":\"a whole number of pulses from {0} to {1}\",\"a_whole_number_of_percent\":\"a whole number of percent from {0} to {1}\",\"a_whole_number_of_bits\":\"a whole number of bits from {0} to {1}\",\"a_number_from_to\":\"a number from {0} to {1}\",\"a_whole_number_or_text\":\"a whole number or text\",\"a_whole_number_or_text_2\":\"[a whole number or text, a whole number or text]\",\"a_whole_number_of_from_2\":\"[a whole number of {0} from {1} to {2}, a whole number of {3} from {4} to {5}]\",\"a_whole_number_of_from_3\":\"[a whole number of {0} from {1} to {2}, a whole number of {3} from {4} to {5}] or a mapping\",\"hoist_or_agv\":\"hoist or agv\",\"itsc_or_enig_or_hi\":\"itsc or enig or hi\",\"leave_or_open_or_close\":\"leave or open or close\",\"none_or_even_or_odd\":\"none or even or odd\",\"port_or_sbfl_or_sbfr\":\"port or sbfl or sbfr or agv_buffer\",\"a_number\":\"a number\",\"a_list\":\"a list\",\"a_list_of\":\"a list of {0}\",\"a_mapping\":\"a mapping\",\"text\":\"text '{0}'\",\"unknown_dialect\":\"unknown dialect {0}\",\"is_the_name_of_a\":\"{0} is the name of a preset\",\"choose_another_name_for_your\":\"choose another name for your dialect\",\"unknown_preset\":\"unknown preset {0}\",\"presets\":\"presets: {0}\",\"dialect\":\"dialect {0}: {1}\",\"unknown_dialect_field\":\"unknown dialect field {0}\",\"unknown_crc\":\"unknown crc {0}\",\"unknown_crc_parameter\":\"unknown crc parameter {0}\",\"unknown_itsc_dialect\":\"unknown iTSC dialect {0}\",\"unknown_enig_dialect\":\"unknown ENIG dialect {0}\",\"unknown_hi_dialect\":\"unknown HI dialect {0}\",\"is_none_of_3\":\"{0} '{1}' is none of {2}\",\"barcode_bytes_is_none_of\":\"barcode_bytes {0} is none of {1}\",\"value_digits_is_none_of\":\"value_digits {0} is none of {1}\",\"pad_is_none_of\":\"pad {0} is none of {1}\",\"crc_covers_type_is_none\":\"crc_covers_type {0} is none of {1}\",\"ack_answers_is_none_of\":\"ack_answers {0} is none of {1}\",\"crc_is_no_name\":\"crc {0} is no name\",\"crc_width_itsc_s_crc\":\"crc width {0}: iTSC's CRC field has 16 bits\",\"max_sub_is_no_number\":\"max_sub {0} is no number of bytes from 1 to 16777215\",\"max_len_is_no_number\":\"max_len {0} is no number of bytes from 1 to 255\",\"is_no_command_code_from\":\"{0} {1} is no command code from 0x0000 to 0xFFFF\",\"and_are_both_0x\":\"{0} and {1} are both 0x{2}\",\"host_id_acs_needs_target\":\"host_id acs needs target include: nothing else would name the device\",\"alias_is_no_text_of\":\"alias {0} is no text of printable ASCII characters\",\"is_no_devicetype_from_1\":\"{0} {1} is no DeviceType from 1 to 255\",\"is_given_to_already\":\"{0} {1} is given to {2} already\",\"cannot_be_a_target_which\":\"{0} {1} cannot be a Target, which is below 0x20: use target omit\",\"its_dest_counts_only_where\":\"its dest counts only where a database is made: teach it, or PUT /api/v1/stations/ID/dest\",\"its_dest_counts_only_where_2\":\"{0}; its dest counts only where a database is made: teach it, or PUT /api/v1/stations/ID/dest\",\"job_stands_in_the_way\":\"job {0} stands in the way: {1}\",\"job_stands_in_the_way_2\":\"job {0} stands in the way: {1} (and {2} more)\",\"carrier_stands_in_the_way\":\"carrier {0} stands in the way: {1}\",\"carrier_stands_in_the_way_2\":\"carrier {0} stands in the way: {1} (and {2} more)\",\"vehicle_stands_in_the_way\":\"vehicle {0} stands in the way: {1}\",\"vehicle_stands_in_the_way_2\":\"vehicle {0} stands in the way: {1} (and {2} more)\",\"station_stands_in_the_way\":\"station {0} stands in the way: {1}\",\"station_stands_in_the_way_2\":\"station {0} stands in the way: {1} (and {2} more)\",\"closure_stands_in_the_way\":\"closure {0} stands in the way: {1}\",\"closure_stands_in_the_way_2\":\"closure {0} stands in the way: {1} (and {2} more)\",\"operation_stands_in_the_way\":\"operation {0} stands in the way: {1}\",\"operation_stands_in_the_way_2\":\"operation {0} stands in the way: {1} (and {2} more)\",\"device_stands_in_the_way\":\"device {0} stands in the way: {1}\",\"device_stands_in_the_way_2\":\"device {0} stands in the way: {1} (and {2} more)\",\"teaching_session_stands_in_the\":\"teaching session {0} stands in the way: {1}\",\"teaching_session_stands_in_the_2\":\"teaching session {0} stands in the way: {1} (and {2} more)\",\"plant_listen_stands_in_the\":\"plant listen stands in the way: {0}\",\"plant_listen_stands_in_the_2\":\"plant listen stands in the way: {0} (and {1} more)\",\"is_now_at_the_same\":\"is {0} now, at the same place\",\"was_at\":\"was at [{0}, {1}]\",\"at\":\"at [{0}, {1}]\",\"by_mm_from_to\":\"by {0} mm, from [{1}, {2}] to [{3}, {4}]\",\"is_a_parking_place_now\":\"is a parking place now\",\"is_no_parking_place_any\":\"is no parking place any more\",\"was_mm_long\":\"was {0} mm long\",\"mm_long\":\"{0} mm long\",\"describes_parameter_in_another_way\":\"describes parameter {0} in another way\",\"describes_parameters_in_another_way\":\"describes parameters {0} in another way\",\"describes_parameters_and_more_in\":\"describes parameters {0} and {1} more in another way\",\"has_another_description\":\"has another description\",\"a_vehicle_that_stands_there\":\"a vehicle that stands there, holds it or is on its way there is not placed in the new plant\",\"change_over_with_no_vehicle\":\"change over with no vehicle there\",\"jobs_that_it_carries_out\":\"jobs that it carries out, its taught offset and its history have no vehicle any more\",\"let_it_end_its_job\":\"let it end its job, and take it off the rail\",\"it_has_another_number_or\":\"it has another number or kind: {0} {1} → {2} {3}\",\"is_it_the_same_machine\":\"is it the same machine? Its offset is kept\",\"jobs_from_and_to_it\":\"jobs from and to it, the carrier in it, its taught DEST and reservations name a station that is not there\",\"end_those_jobs_move_the\":\"end those jobs, move the carrier, or keep the name\",\"it_was_a_and_is\":\"it was a {0} and is a {1}: other vehicles, or other commands, serve it\",\"end_its_jobs_first\":\"end its jobs first\",\"it_is_served_from_instead\":\"it is served from {0} instead of {1}: its taught DEST was measured at the other\",\"teach_it_anew_before_jobs\":\"teach it anew before jobs go there\",\"no_way_leads_there_and\":\"no way leads there and back any more from where most stations are: its jobs would wait for ever\",\"add_the_missing_track\":\"add the missing track\",\"export_it_first_get_api\":\"export it first (GET /api/v1/teaching/{0}), and keep the name if it is the same place or machine\",\"its_taught_dest_version_serves\":\"its taught DEST (version {0}) serves nobody any more\",\"its_taught_offset_version_serves\":\"its taught OFFSET (version {0}) serves nobody any more\",\"its_in_the_plant_file_does\":\"its {0} in the plant file does not count ({1}): version {2} of the database holds, by {3}, {4} ({5})\",\"to_take_the_files_put\":\"to take the file's: PUT /api/v1/{0}s/{1}/{2} {3}\",\"what_was_noted_of_it\":\"what was noted of it goes ({0})\",\"the_values_that_were_read\":\"the values that were read of it are not shown any more\",\"back_it_up_first_post\":\"back it up first: POST /api/v1/drives/ID/backups\",\"end_it_or_cancel_it\":\"end it, or cancel it, first\",\"vehicles_are_to_connect_to\":\"vehicles are to connect to {0}:{1}, where the controller does not listen\",\"stop_the_controller_and_start\":\"stop the controller, and start it with the new file\",\"it_names_which_the_new\":\"it names {0}, which the new plant does not have\",\"it_names_which_the_new_2\":\"it names {0}, which the new plant does not have.\",\"cannot_be_reached_from_the\":\"{0} cannot be reached from the other stations in the new plant\",\"it_is_s_which_the\":\"it is {0}'s, which the new plant does not have\",\"it_is_at_which_the\":\"it is at {0}, which the new plant does not have\",\"tell_where_it_is_put\":\"tell where it is: PUT /api/v1/carriers/ID\",\"it_may_be_on_the\":\"it may be on the rail, and the new plant does not have it\",\"take_it_off_the_rail\":\"take it off the rail, and say so: POST /api/v1/vehicles/{0}/release, verdict off_rail\",\"it_stands_at_holds_or\":\"it stands at, holds or drives to {0}, which the new plant does not have\",\"move_it_elsewhere_first\":\"move it elsewhere first\",\"it_drives_from_to_where\":\"it drives from {0} to {1}, where the new plant has no track\",\"let_it_end_its_way\":\"let it end its way first\",\"it_names_a_station_or\":\"it names a station or vehicle that the new plant does not have\",\"close_it_first\":\"close it first\",\"its_dest_was_taught_at\":\"its DEST was taught at {0}, and it is served from {1}: a hoist would reach elsewhere\",\"patch_api_v1_stations_with\":\"PATCH /api/v1/stations/{0} with out_of_service first; teach it anew afterwards\",\"is_closed_and_of_it\":\"{0} is closed ({1}), and {2} of it is not in the new plant\",\"to_is_closed_and_of\":\"{0} to {1} is closed ({2}), and {3} of it is not in the new plant\",\"its_owner_opens_it_first\":\"its owner opens it first\",\"it_is_under_way_at\":\"it is under way at {0}, which the new plant does not have\",\"somebody_works_at_it_lockout\":\"somebody works at it (lockout), and the new plant does not have it\",\"its_owner_lifts_the_lockout\":\"its owner lifts the lockout first\",\"write_yaml_plants_small_yaml\":\"write YAML: plants/small.yaml shows how\",\"this_is_no_yaml\":\"this is no YAML: {0}\",\"the_file_is_empty\":\"the file is empty\",\"a_second_document_starts_here\":\"a second document starts here\",\"one_file_holds_one_plant\":\"one file holds one plant\",\"an_alias_cannot_be_used\":\"an alias (*{0}) cannot be used here\",\"write_the_value_again\":\"write the value again\",\"this_is_nested_more_than\":\"this is nested more than {0} levels deep\",\"a_tag_cannot_be_used\":\"a tag ({0}) cannot be used here\",\"the_file_has_more_than_2\":\"the file has more than {0} values\",\"write_barcodes_as_ranges\":\"write barcodes as ranges\",\"a_text_is_longer_than\":\"a text is longer than {0} characters\",\"shorten_it\":\"shorten it\",\"has_a_character_that_cannot\":\"{0} has a character that cannot be shown\",\"has_a_character_that_cannot_2\":\"'{0}' has a character that cannot be shown\",\"a_key_must_be_text\":\"a key must be text or a number\",\"quote_it_if_it_begins\":\"quote it if it begins with [ { * or &\",\"is_given_twice_the_first\":\"{0} is given twice: the first time on line {1}\",\"is_no_number_of_a\":\"{0}: {1} is no number of a buffer here\",\"is_no_number_of_a_2\":\"{0}: {1} is no number of a door here\",\"is_no_number_of_an\":\"{0}: {1} is no number of an AGV here\",\"is_no_number_of_here\":\"{0}: {1} is no number of {2} here\",\"has_the_same_number_on\":\"{0} has the same number on {1} as {2}: {3}\",\"give_it_under_links\":\"give it under links\",\"unknown_link\":\"unknown link {0}\",\"link_speaks_this_needs\":\"link {0} speaks {1}, this needs {2}\",\"name_another_link_or_correct\":\"name another link, or correct its protocol\",\"is_reached_in_two_ways\":\"{0} is reached in two ways\",\"is_reached_in_no_way\":\"{0} is reached in no way\",\"give_address_host_port_or\":\"give address: HOST:PORT, or serial: {device: ...}\",\"is_reached_where_is\":\"{0} is reached where {1} is\",\"each_link_needs_its_own\":\"each link needs its own\",\"an_itsc_line_carries_one\":\"{0}: an iTSC line carries one hoist alone\",\"give_the_hoist_an_address\":\"give the hoist an address under vehicles\",\"known_preset\":\"known: preset, {0}\",\"no_track_leads_between_and\":\"no track leads between {0} and {1}, which {2} stands across\",\"name_two_neighbours_on_the\":\"name two neighbours on the track\",\"no_station_has_buffer\":\"no station has buffer {0}\",\"name_it_at_the_station\":\"name it at the station where it stands\",\"is_no_time_of_day\":\"{0} is no time of day\",\"is_no_time_of_day_2\":\"'{0}' is no time of day\",\"write_from_to_in_utc\":\"write FROM-TO in UTC, such as \\\"12:00-12:30\\\"\",\"nothing_is_on_link\":\"nothing is on link {0}\",\"name_it_at_a_device\":\"name it at a device\",\"is_a_name_under_already\":\"{0} is a name under {1} already\",\"choose_another_name_2\":\"choose another name\",\"known_others_go_into_the\":\"known: {0}; others go into the link's dialect\",\"is_no_name_on_the\":\"{0} is no name on the wire (PROTOCOLS 3.2)\",\"has_the_same_alias_as\":\"{0} has the same alias as {1}: {2}\",\"is_a_at_on_the\":\"{0} is a {1} at {2}, on the track of AGVs\",\"hoists_and_agvs_need_track\":\"hoists and AGVs need track of their own\",\"is_a_hoist_and_starts\":\"{0} is a hoist and starts at {1}, on the track of AGVs\",\"idle_hoists_have_no_place\":\"idle hoists have no place to park\",\"give_barcodes_of_their_track\":\"give barcodes of their track under parking\",\"zone_is_soft_and_lies\":\"zone {0} is soft and lies on the track of AGVs, where soft zones count for nothing\",\"give_it_a_capacity_instead\":\"give it a capacity instead\",\"there_is_no_charger\":\"there is no charger\",\"give_one_under_chargers\":\"give one under chargers\",\"agvs_are_never_sent_to\":\"AGVs are never sent to charge: they report no battery level\",\"say_when_under_charging_trips\":\"say when under charging: trips, after or windows\",\"unknown_barcode\":\"unknown barcode {0}\",\"give_it_under_barcodes\":\"give it under barcodes\",\"unknown_station\":\"unknown station {0}\",\"give_it_under_stations\":\"give it under stations\",\"unknown_event\":\"unknown event {0}\",\"cannot_be_a_name_here\":\"{0} cannot be a name here\",\"cannot_be_a_name_here_2\":\"'{0}' cannot be a name here\",\"use_letters_digits_and_only\":\"use letters, digits and . _ - : + @ only, at most 64, beginning with a letter or digit\",\"letters_digits_and_only_at\":\"letters, digits and . _ - : + @ only, at most 64, beginning with a letter or digit\",\"is_a_hoist_it_has\":\"{0} is a hoist: it has a line of its own\",\"leave_link_out\":\"leave link out\",\"is_a_reference_vehicle_its_3\":\"{0} is a reference vehicle: its offset is zero, so the one given is not used\",\"s_curve_speed_is_more\":\"{0}'s curve_speed {1} is more than its max_speed {2}\",\"both_are_in_mm_s\":\"both are in mm/s\",\"is_an_agv_is_a_2\":\"{0} is an AGV: {1} is a hoist's\",\"is_an_agv_and_has_2\":\"{0} is an AGV and has no link\",\"add_link_the_name_of\":\"add link: the name of an enig link\",\"connects_to_us_so_its\":\"{0} connects to us, so its address has no port\",\"write_the_host_alone_or\":\"write the host alone, or leave listen out\",\"connects_to_us_but_the\":\"{0} connects to us, but the plant does not listen\",\"give_listen_host_port_at\":\"give listen: HOST:PORT at the top of the file\",\"has_no_address_to_connect\":\"{0} has no address to connect to\",\"give_address_host_port_or_2\":\"give address: HOST:PORT, or listen: true\",\"has_the_same_dev_id\":\"{0} has the same dev_id as {1}: {2}\",\"has_the_same_address_as\":\"{0} has the same address as {1}: {2}\",\"has_the_same_start_as\":\"{0} has the same start as {1}: {2}\",\"s_limits_are_upside_down\":\"{0}'s {1} limits are upside down: {2} > {3}\",\"s_max_count_is_more\":\"{0}'s max_count {1} is more than its dialect's packets hold: {2}\",\"lower_it_or_raise_max\":\"lower it, or raise max_sub in a dialect of your own\",\"km_of_track\":\"{0} km of track\",\"m_of_track\":\"{0} m of track\",\"side_buffer_left\":\"side buffer, left\",\"side_buffer_right\":\"side buffer, right\",\"agv_buffer\":\"AGV buffer\",\"one_way_track\":\"one-way track\",\"two_way_track\":\"two-way track\",\"vehicle_s_start\":\"vehicle's start\",\"two_way_kilometres\":\"two-way kilometres\",\"strongly_connected_parts\":\"strongly connected parts\",\"buffers_for_fewer_than_two\":\"buffers for fewer than two vehicles\",\"barcodes_that_exclude_others\":\"barcodes that exclude others\",\"shortest_edge_mm\":\"shortest edge, mm\",\"middle_edge_mm\":\"middle edge, mm\",\"longest_edge_mm\":\"longest edge, mm\",\"mean_way_between_ports_m\":\"mean way between ports, m\",\"parking_places\":\"parking places\",\"agv_buffers\":\"AGV buffers\",\"side_buffers\":\"side buffers\",\"track_is_shorter_than_the\":\"track is shorter than the straight line between its ends\",\"another_barcode_lies_within_mm\":\"another barcode lies within {0} mm, and no track connects them\",\"doubled_barcodes\":\"doubled barcodes\",\"are_both_on_the_rail\":\"are both on the rail, or is one an old name of the other?\",\"track_crosses_other_track_without\":\"track crosses other track without a common barcode: vehicles exclude one another there\",\"is_a_barcode_missing_or\":\"is a barcode missing, or does one pass above the other?\",\"barcodes_of_other_branches_lie\":\"barcodes of other branches lie within the clearance of {0} mm: one vehicle at a time\",\"between_two_branches_there_is\":\"between two branches there is no room for two vehicles of {0} mm: nobody waits there\",\"short_buffers\":\"short buffers\",\"grants_pass_through_lay_barcodes\":\"grants pass through; lay barcodes closer, or branches apart\",\"barcodes_are_nearer_to_each\":\"barcodes are nearer to each other than a vehicle is long ({0} mm): it covers more than one\",\"dense_barcodes\":\"dense barcodes\",\"a_station_lies_at_a\":\"a station lies at a merge or diverge: whoever stops there bars both ways\",\"stations_at_branches\":\"stations at branches\",\"serve_it_from_a_barcode\":\"serve it from a barcode before or behind\",\"parking_at_branches\":\"parking at branches\",\"a_parking_place_lies_at\":\"a parking place lies at a merge or diverge\",\"a_parking_place_is_a\":\"a parking place is a station's barcode as well: an idle vehicle may stand in the way there\",\"parking_at_stations\":\"parking at stations\",\"closed_a_barcode_cuts_off\":\"closed, a barcode cuts off up to {0} places of stations: there is no way around\",\"closed_a_barcode_cuts_off_2\":\"closed, a barcode cuts off up to {0} of {1} places of stations: there is no way around\",\"no_way_around\":\"no way around\",\"a_bay_of_barcodes_a\":\"a bay of {0} barcodes a side has no room for {1} shortcuts\",\"carriers_do_not_fit_ports\":\"{0} carriers do not fit {1} ports\",\"vehicles_do_not_fit_barcodes\":\"{0} vehicles do not fit: {1} barcodes may be started from\",\"bays_they_come_in_pairs\":\"{0} bays: they come in pairs, one on each side of the spine\",\"the_track_would_be_too\":\"the track would be too close together: {0}\",\"column_pitch_and_lane_gap\":\"column {0}, pitch {1} and lane_gap {2} or more\",\"columns_have_room_for_turnarounds\":\"{0} columns have room for {1} turnarounds each way\",\"leave_one_of_them_out\":\"leave one of them out\",\"there_is_no_catalogue_its\":\"there is no catalogue {0}: its drives have raw access only\",\"put_yaml_into_or_leave\":\"put {0}.yaml into {1}, or leave the model out\",\"zone_is_closed_and_of\":\"zone {0} is closed ({1}), and {2} of it is not in the new plant\",\"degree_needs_more_than_control\":\"degree {0} needs more than {1} control points, there are {2}\",\"the_knot_vector_has_values\":\"the knot vector has {0} values where {1} are needed\",\"the_knot_vector_does_not\":\"the knot vector does not rise\",\"a_weight_is_not_above\":\"a weight is not above 0\",\"a_control_point_has_no\":\"a control point has no {0}\",\"this_is_a_plant_file\":\"this is a plant file already\",\"see_what_is_wrong_with\":\"see what is wrong with it: hoistway check FILE\",\"geojson_is_written_not_read\":\"GeoJSON is written, not read: it does not say which mark comes next\",\"a_lif_file_has_layouts\":\"a LIF file has layouts, a node-link graph has nodes and links\",\"this_json_is_no_layout\":\"this JSON is no layout that is known\",\"opentcs_begins_with_model_graphml\":\"openTCS begins with <model>, GraphML with <graphml>\",\"this_xml_is_no_layout\":\"this XML is no layout that is known: it begins with <{0}>\",\"where_on_earth_the_plant\":\"where on earth the plant lies: positions are metres on the plan (give --origin)\",\"names_of\":\"names of {0}\",\"soft_zones\":\"{0} soft zones\",\"soft_zone\":\"{0} soft zone\",\"this_json_is_no_node\":\"this JSON is no node-link graph\",\"it_is_an_object_with\":\"it is an object with nodes, and links or edges\",\"the_graph_has_neither_links\":\"the graph has neither links nor edges\",\"write_it_with_networkx_s\":\"write it with networkx's node_link_data\",\"node_link_json\":\"node-link JSON ({0}), {1}\",\"no_edges\":\"no edges\",\"ends_of_edges_are_positions\":\"ends of edges are positions in the list of nodes, as networkx 1 and d3 wrote them\",\"this_xml_is_no_graphml\":\"this XML is no GraphML: it has no graph\",\"node_line\":\"node {0} (line {1})\",\"edge_line\":\"edge (line {0})\",\"the_graph_is_undirected_all\":\"the graph is undirected: all track is two-way\",\"write_a_directed_graph_for\":\"write a directed graph for one-way track\",\"the_node_has_no_id\":\"the node has no id: left out\",\"attributes_that_are_not_understood\":\"attributes that are not understood\",\"the_node_has_no_position\":\"the node has no position: left out\",\"give_it_x_and_y\":\"give it x and y, or pos\",\"a_station_without_an_id\":\"a station without an id: left out\",\"give_it_one\":\"give it one\",\"the_edge_has_no_source\":\"the edge has no source or no target: left out\",\"give_both\":\"give both\",\"correct_it\":\"correct it\",\"write_true_or_false\":\"write true or false\",\"there_is_no_mark_with\":\"{0}: there is no mark with a position in it\",\"there_is_no_mark_with_2\":\"{0}: there is no mark with a position in it: {1}\",\"marks_and_pieces_of_track\":\"{0} marks and {1} pieces of track\",\"are_more_than_a_plant\":\"{0}: {1} are more than a plant file holds\",\"split_the_layout\":\"split the layout\",\"several_files_make_one_layout\":\"several files make one layout only where all are tables: CSV or workbooks\",\"this_is_no_it_looks\":\"this is no {0}: it looks like {1}\",\"leave_format_out\":\"leave --format out\",\"imported_by_hoistway_layout_import\":\"Imported by hoistway layout import from {0}: {1}.\",\"wrong_in_the_source\":\"Wrong in the source\",\"to_supply\":\"To supply\",\"is_not_utf_8_at\":\"{0} is not UTF-8: {1} at byte {2}\",\"save_it_as_utf_8_2\":\"save it as UTF-8\",\"the_file_ends_in_the\":\"the file ends in the middle: was it copied whole?\",\"correct_it_there\":\"correct it there\",\"is_no_json_line_column\":\"{0} is no JSON: line {1}, column {2}: {3}\",\"is_nested_too_deep_to\":\"{0} is nested too deep to be a layout\",\"is_no_json_that_can\":\"{0} is no JSON that can be read: {1}\",\"is_read_as\":\"{0} is read as {1}\",\"is_a_number_where_a\":\"{0} is a number where a text is meant\",\"is_no_text\":\"{0} is no text\",\"is_a_text_where_a\":\"{0} is a text where a number is meant\",\"is_one_object_where_a\":\"{0} is one object where a list is meant\",\"is_no_list\":\"{0} is no list\",\"write_it_in_brackets\":\"write it in brackets\",\"is_no_object_left_out\":\"is no object: left out\",\"write_it_in_braces\":\"write it in braces\",\"how_vehicles_are_turned_on\":\"how vehicles are turned on track\",\"where_vehicles_may_turn\":\"where vehicles may turn\",\"how_fast_vehicles_may_turn\":\"how fast vehicles may turn\",\"heights_of_load_handling\":\"heights of load handling\",\"where_vehicles_may_be_taken\":\"where vehicles may be taken into control\",\"there_is_no_metainformation\":\"there is no metaInformation\",\"there_is_no_layoutid\":\"there is no layoutId\",\"there_is_no_layoutversion\":\"there is no layoutVersion\",\"lifversion_is_read_as\":\"lifVersion is {0}: read as {1}\",\"lifversion_is_missing_read_as\":\"lifVersion is missing: read as {0}\",\"no_version\":\"(no version)\",\"the_file_is_a_list\":\"the file is a list of layouts where an object with layouts is meant\",\"the_file_is_one_layout\":\"the file is one layout where an object with layouts is meant\",\"this_json_holds_no_layouts\":\"this JSON holds no layouts\",\"a_lif_file_is_an\":\"a LIF file is an object with layouts\",\"the_file_has_no_layouts\":\"the file has no layouts\",\"a_lif_file_is_an_2\":\"a LIF file is an object with a list layouts\",\"there_is_no_layout_in\":\"there is no layout {0} in it\",\"there_are_2\":\"there are: {0}\",\"the_node_has_no_nodeid\":\"the node has no nodeId: left out\",\"give_nodeposition_with_x_and\":\"give nodePosition with x and y\",\"x_and_y_stand_at\":\"x and y stand at the node itself, without nodePosition\",\"no_vehicle_type_is_named\":\"no vehicle type is named for the node: taken is every type\",\"how_vehicles_are_turned_at\":\"how vehicles are turned at nodes\",\"drawn_m_to_the_right\":\"drawn {0} m to the right, beside the others: a plant has one plan\",\"or_import_one_layout_alone\":\"or import one layout alone with --layout\",\"the_edge_has_no_edgeid\":\"the edge has no edgeId\",\"the_edge_has_no_startnodeid\":\"the edge has no startNodeId or no endNodeId: left out\",\"an_edge_from_level_to\":\"an edge from level to level: lifts are not driven\",\"no_vehicle_type_is_named_2\":\"no vehicle type is named for the edge: taken is every type\",\"edges_that_are_not_for\":\"edges that are not for vehicle type {0}\",\"the_trajectory_is_no_curve\":\"the trajectory is no curve ({0}): taken is the straight line\",\"track_for_loaded_vehicles_only\":\"track for loaded vehicles only: any vehicle may be sent there\",\"track_for_unloaded_vehicles_only\":\"track for unloaded vehicles only: any vehicle may be sent there\",\"track_for_vehicles_only_any\":\"track for {0} vehicles only: any vehicle may be sent there\",\"which_loads_may_be_carried\":\"which loads may be carried there\",\"actions_on_track\":\"actions on track\",\"there_are_no_stations_taken\":\"there are no stations: taken as none\",\"the_station_has_no_stationid\":\"the station has no stationId: left out\",\"the_height_of_stations\":\"the height of stations\",\"interactionnodeids_is_one_text_where\":\"interactionNodeIds is one text where a list is meant\",\"node_of_it_is_nowhere\":\"node {0} of it is nowhere given\",\"correct_interactionnodeids\":\"correct interactionNodeIds\",\"vehicles_charge_at_the_node\":\"vehicles charge at the node, and no station names it: it becomes a charger\",\"loads_are_handled_at_the\":\"loads are handled at the node, and no station names it: it becomes one\",\"taken_is_what_any_vehicle\":\"taken is what any vehicle type may use: {0}\",\"or_choose_one_with_vehicle\":\"or choose one with --vehicle-type\",\"no_vehicle_type_is_named_3\":\"no vehicle type {0} is named: {1}\",\"lif\":\"LIF {0}, {1}\",\"speeds_in_percent\":\"{0} speeds in percent\",\"speed_in_percent\":\"{0} speed in percent\",\"lengths_other_than_the_distance\":\"{0} lengths other than the distance of their ends\",\"length_other_than_the_distance\":\"{0} length other than the distance of their ends\",\"marks_of_curves\":\"{0} marks of curves\",\"mark_of_curves\":\"{0} mark of curves\",\"parking_places_2\":\"{0} parking places\",\"parking_place\":\"{0} parking place\",\"obstacle_sensor_areas_of_edges\":\"obstacle-sensor areas of {0} edges\",\"obstacle_sensor_areas_of_edge\":\"obstacle-sensor areas of {0} edge\",\"pulses_look_down_speed_and\":\"pulses, look-down, speed and fallbacks of {0} stations\",\"pulses_look_down_speed_and_2\":\"pulses, look-down, speed and fallbacks of {0} station\",\"the_plant_s_clearance\":\"the plant's clearance\",\"process_codes\":\"process codes\",\"alarm_codes\":\"alarm codes\",\"event_numbers\":\"event numbers\",\"process_codes_2\":\"{0} process codes\",\"process_code\":\"{0} process code\",\"alarm_codes_2\":\"{0} alarm codes\",\"alarm_code\":\"{0} alarm code\",\"event_numbers_2\":\"{0} event numbers\",\"event_number\":\"{0} event number\",\"when_agvs_charge\":\"when AGVs charge\",\"how_hoists_share_the_track\":\"how hoists share the track (traffic)\",\"what_idle_hoists_do_idle\":\"what idle hoists do (idle)\",\"where_vehicles_connect_to_listen\":\"where vehicles connect to (listen)\",\"names_of_alarm_and_process\":\"names of alarm and process codes, event numbers\",\"buffer_and_alias_of_stations\":\"buffer and alias of {0} stations\",\"buffer_and_alias_of_station\":\"buffer and alias of {0} station\",\"no_table_has_barcodes_with\":\"no table has barcodes with positions: no column is understood as {0}\",\"no_table_has_barcodes_with_2\":\"no table has barcodes with positions: no column is understood as all three\",\"all_three\":\"all three\",\"name_the_columns_barcode_x\":\"name the columns barcode, x and y (바코드, X, Y), in one table\",\"a_column_that_is_not\":\"a column that is not understood\",\"pieces_of_track\":\"pieces of track\",\"a_table_that_says_nothing\":\"a table that says nothing about its barcodes\",\"a_table_without_barcodes\":\"a table without barcodes\",\"the_row_has_no_barcode\":\"the row has no barcode: left out\",\"fill_in_the_barcode\":\"fill in the barcode\",\"the_barcode_has_no_position\":\"the barcode has no position: left out\",\"fill_in_x_and_y\":\"fill in x and y\",\"one_length_for_several_ways\":\"one length for several ways on: it is taken for each\",\"give_one_for_each\":\"give one for each\",\"the_track_has_no_beginning\":\"the track has no beginning or no end: left out\",\"fill_in_both_barcodes\":\"fill in both barcodes\",\"write_one_way_or_two\":\"write one-way or two-way\",\"write_yes_or_no\":\"write yes or no\",\"only_some_of_shft_rota\":\"only some of shft, rota and lift are given: left out\",\"give_all_three\":\"give all three\",\"the_row_has_no_vehicle\":\"the row has no vehicle: left out\",\"fill_in_its_name\":\"fill in its name\",\"no_column_says_which_barcode\":\"no column says which barcode comes next: the plan has no track\",\"add_a_column_next_or\":\"add a column next (다음 바코드), or say --in-order: each row leads to the next (--loop: in a ring)\",\"at_most_are_made_up\":\"at most {0} are made up\",\"starts_at_which_is_nowhere\":\"starts at {0}, which is nowhere given\",\"starts_at_where_another_vehicle\":\"starts at {0}, where another vehicle stands\",\"no_barcode_is_free_where\":\"no barcode is free where it could start, reached and left by track, with its length around\",\"no_barcode_is_free_where_2\":\"{0}: no barcode is free where it could start, reached and left by track, with its length around\",\"give_start_or_fewer_vehicles\":\"give start, or fewer vehicles\",\"a_link_at_this_machine\":\"a link at this machine, for simulation\",\"write_the_real_line_s\":\"write the real line's address, or serial:, under links\",\"the_agv_s_number_on\":\"the AGV's number on its link is made up\",\"write_the_real_one_as\":\"write the real one as dev_id\",\"barcodes_are_no_numbers_so\":\"barcodes are no numbers, so vehicles speak a dialect of text barcodes\",\"see_dialects\":\"see dialects\",\"the_vehicle_s_number_is\":\"the vehicle's number is made up\",\"an_address_at_this_machine\":\"an address at this machine, for simulation\",\"write_the_real_one_as_2\":\"write the real one as address: HOST:PORT\",\"vehicles_name_dev_id_and\":\"vehicles: name, dev_id and address\",\"vehicles_name_link_and_dev\":\"vehicles: name, link and dev_id\",\"under_vehicles_vehicles_n_makes\":\"under vehicles; --vehicles N makes simulated ones up\",\"stations_where_carriers_are_taken\":\"stations: where carriers are taken and put down\",\"under_stations\":\"under stations\",\"parking_where_idle_vehicles_may\":\"parking: where idle vehicles may wait\",\"a_list_of_barcodes_under\":\"a list of barcodes under parking\",\"the_vehicle_s_offset_is\":\"the vehicle's offset is not known\",\"teach_it_docs_teaching_md\":\"teach it (docs/teaching.md), or give offset\",\"the_port_s_target_pulses\":\"the port's target pulses are not known\",\"teach_it_docs_teaching_md_2\":\"teach it (docs/teaching.md), or give dest\",\"agvs_read_tags_of_four\":\"AGVs read tags of four characters\",\"barcodes_are_numbers_or_texts\":\"barcodes are numbers, or texts of six characters at most\",\"renamed_give_your_own_with\":\"renamed: {0} (give your own with --names)\",\"renamed_and_its_letters_are_lost\":\"renamed, and its letters are lost: names are Latin letters, digits and . _ - : + @\",\"write_the_names_into_the_list\":\"write the names into the list by which hosts are to order, and import it again\",\"renamed_names_are_letters_digits\":\"renamed: names are letters, digits and . _ - : + @, each used once\",\"shown_on_vehicles_so_their\":\"shown on vehicles so: their displays hold {0} characters\",\"is_no_number\":\"{0} is no number\",\"the_number_is_too_large\":\"the number is too large\",\"the_number_is_too_large_2\":\"{0}: the number is too large\",\"is_no_finite_number\":\"{0} is no finite number\",\"a_closed_path_opentcs_lets\":\"a closed path: openTCS lets nobody drive on it\",\"the_root_element_is_not\":\"the root element is {0}, not model\",\"opentcs_plant_model\":\"openTCS plant model {0}, {1}\",\"opentcs_plant_model_no_version\":\"openTCS plant model (no version), {0}\",\"version_is_read_like_versions\":\"version {0} is read like versions {1}\",\"version_is_read_like_versions_2\":\"version {0} is read like versions {1} and {2}\",\"elements_that_are_not_known\":\"elements that are not known here\",\"it_has_no_name_left\":\"it has no name: left out\",\"the_point_has_no_position\":\"the point has no position: left out\",\"give_positionx_and_positiony\":\"give positionX and positionY\",\"heights_of_points_a_plant\":\"heights of points: a plant has one plan\",\"how_vehicles_are_turned_at_2\":\"how vehicles are turned at points\",\"the_point_has_no_position_2\":\"the point has no position of its own: taken is that of the drawing\",\"the_path_has_no_sourcepoint\":\"the path has no sourcePoint or no destinationPoint: left out\",\"keep_it_with_keep_locked\":\"keep it with --keep-locked, and close it in the running plant\",\"a_locked_path_close_it\":\"a locked path: close it in the running plant\",\"operations_of_peripherals_on_paths\":\"operations of peripherals on paths\",\"doors_are_given_under_doors\":\"doors are given under doors\",\"no_speed_either_way_nobody\":\"no speed either way: nobody may drive there\",\"driven_backwards_as_well_two\":\"driven backwards as well: two-way track\",\"drop_the_run_that_leads\":\"drop the run that leads back if it is not wanted\",\"its_type_is_nowhere_given\":\"its type {0} is nowhere given\",\"a_locked_location_put_it\":\"a locked location: put it out of service in the running plant\",\"a_location_that_is_linked\":\"a location that is linked to no point\",\"give_it_a_station_at\":\"give it a station at a barcode\",\"blocks_of_type\":\"blocks of type {0}\",\"its_member_is_nowhere_given\":\"its member {0} is nowhere given\",\"correct_or_leave_it_out\":\"correct or leave it out\",\"left_out\":\"left out\",\"to_supply_2\":\"to supply\",\"the_layout_has_no_such\":\"the layout has no such mark\",\"correct_it_in_the_file\":\"correct it in the file of names\",\"the_position_is_no_number\":\"the position is no number, so the mark is left out\",\"give_x_and_y\":\"give x and y\",\"the_position_is_more_than\":\"the position is more than {0} km away\",\"is_given_again_alike\":\"{0} is given again, alike ({1})\",\"is_given_twice_at_different\":\"{0} is given twice, at different places: kept is the first ({1})\",\"lies_where_another_node_lies\":\"lies where another node lies, and becomes one mark with it (turns and levels are not told apart)\",\"leads_to_which_is_nowhere\":\"leads to {0}, which is nowhere given: left out\",\"give_the_mark_a_position\":\"give the mark a position, or leave the track out\",\"leads_from_a_mark_to\":\"leads from a mark to itself\",\"leads_from_node_to_node\":\"leads from node to node at one place: a turn, which vehicles make by themselves\",\"the_same_track_is_given\":\"the same track is given again\",\"a_second_way_between_the\":\"a second way between the same two marks: kept is the first\",\"the_length_is_no_number\":\"the length is no number: taken is the distance of the ends\",\"the_length_is_below_zero\":\"the length is below zero: taken is the distance of the ends\",\"the_length_is_0_taken\":\"the length is 0: taken is the distance of the ends\",\"both_ends_lie_at_one\":\"both ends lie at one place and no length is given: left out\",\"correct_a_position_or_give\":\"correct a position, or give the length\",\"longer_than_km_left_out\":\"longer than {0} km: left out\",\"the_speed_is_not_above\":\"the speed is not above 0: taken is 100 percent\",\"the_speed_is_above_the\":\"the speed is above the vehicles' own: taken is 100 percent\",\"is_a_station_already_left\":\"{0} is a station already ({1}): left out\",\"its_mark_is_nowhere_given\":\"its mark {0} is nowhere given\",\"its_mark_is_nowhere_given_2\":\"its mark {0} is nowhere given: left out\",\"no_mark_is_named_for\":\"no mark is named for it\",\"no_mark_is_named_for_2\":\"no mark is named for it: left out\",\"name_the_mark_where_vehicles\":\"name the mark where vehicles stop for it\",\"a_station_is_reached_from\":\"a station is reached from one mark: kept is {0}\",\"give_stations_of_their_own\":\"give stations of their own to the others if they hold carriers of their own\",\"cannot_be_a_carrier_letters\":\"{0} cannot be a carrier: {1} letters and digits, each once\",\"correct_its_name\":\"correct its name\",\"hoists_do_not_charge\":\"hoists do not charge\",\"vehicles_are_mm_long\":\"vehicles are {0} mm long, drive up to {1} mm/s and brake with {2} mm/s² where the file does not say\",\"write_what_is_true_under\":\"write what is true under vehicle_defaults\",\"clearance_is_0\":\"clearance is 0: tracks side by side do not exclude each other\",\"write_it_in_mm_as_clearance\":\"write it, in mm, as clearance\",\"agvs_charge_after_trips_or\":\"AGVs charge after {0} trips or an hour: layouts do not say when\",\"say_when_under_charging\":\"say when under charging\",\"in_it_is_nowhere_given\":\"{0} in it is nowhere given\",\"a_zone_without_marks\":\"a zone without marks\",\"no_row_names_columns_that\":\"{0}: no row names columns that are known\",\"this_is_no_text_it\":\"this is no text: it holds zero bytes\",\"give_csv_xlsx_json_or\":\"give CSV, XLSX, JSON or XML\",\"this_is_no_text_in\":\"this is no text in {0}\",\"name_its_encoding_with_encoding\":\"name its encoding with --encoding\",\"unknown_encoding\":\"unknown encoding {0}\",\"more_than_rows\":\"more than {0} rows\",\"is_a_quotation_mark_left\":\"is a quotation mark left open?\",\"row\":\"row {0}: {1}\",\"save_it_anew_as_xlsx\":\"save it anew as XLSX without a password, or as CSV\",\"is_no_workbook_that_can\":\"{0} is no workbook that can be read: {1}\",\"no_row_names_columns_that_2\":\"no row names columns that are known\",\"no_sheet_has_columns_that\":\"{0}: no sheet has columns that are known\",\"workbook_sheets\":\"workbook, sheets {0}\",\"is_a_damaged_workbook\":\"{0} is a damaged workbook: {1}\",\"save_it_anew\":\"save it anew\",\"unpacks_to_mb_that_is\":\"{0} unpacks to {1} MB: that is no list of barcodes\",\"needed_are_at_least_a\":\"needed are at least a barcode (바코드), x, y and the next barcode (다음 바코드), or from and to\",\"needed_are_at_least_a_2\":\"needed are at least a barcode (바코드), x, y and the next barcode (다음 바코드), or from and to; the first row has: {0}\",\"positions_are_in_the_file\":\"positions are in {0}: the file does not name the unit\",\"say_unit_mm_or_unit\":\"say --unit mm or --unit m\",\"y_grows_downwards_as_on\":\"y grows downwards, as on a screen\",\"say_y_up_if_the\":\"say --y-up if the drawing stands on its head\",\"lengths_are_in_as_the\":\"lengths are in {0}, as the positions tell\",\"name_the_unit_length_m\":\"name the unit: length (m)\",\"shares_of_the_vehicles_own\":\"shares of the vehicles' own\",\"percent_of_the_vehicles_own\":\"percent of the vehicles' own\",\"speeds_are\":\"speeds are {0}\",\"name_the_unit_speed_or\":\"name the unit: speed (%) or speed (mm/s)\",\"declares_a_document_type_or\":\"{0} declares a document type or entities, which layouts have no need of: refused\",\"export_it_anew_without_a\":\"export it anew without a DOCTYPE\",\"is_no_xml_line_column\":\"{0} is no XML: line {1}, column {2}: {3}\",\"is_no_xml_that_can\":\"{0} is no XML that can be read: {1}\",\"vehicle_is_not_connected\":\"vehicle {0} is not connected\",\"check_its_power_and_its\":\"check its power and its network; it is dialled again by itself\",\"vehicle_has_not_yet_answered\":\"vehicle {0} has not yet answered STATUS since it connected\",\"try_again_once_it_has\":\"try again once it has\",\"the_newest_status_of_vehicle\":\"the newest STATUS of vehicle {0} is {1} s old\",\"the_newest_status_of_is\":\"the newest STATUS of {0} is {1} s old\",\"try_again_once_it_answers\":\"try again once it answers STATUS\",\"vehicle_has_not_yet_answered_2\":\"vehicle {0} has not yet answered {1}\",\"has_not_yet_answered_status\":\"{0} has not yet answered STATUS since it connected\",\"has_not_yet_answered\":\"{0} has not yet answered {1}\",\"wait_for_its_answer_or\":\"wait for its answer, or stop the vehicle\",\"the_path_has_elements_and\":\"the path has {0} elements, and vehicle {1} takes at most {2}\",\"the_path_has_elements_and_2\":\"the path has {0} elements, and {1} takes at most {2}\",\"send_the_first_part_and\":\"send the first part and extend it by XMOVE\",\"vehicle_is_in_manual\":\"vehicle {0} is in MANUAL\",\"vehicle_is_in_semi\":\"vehicle {0} is in SEMI\",\"vehicle_is_in_auto\":\"vehicle {0} is in AUTO\",\"vehicle_is_in_an_undefined\":\"vehicle {0} is in an undefined mode\",\"switch_it_to\":\"switch it to {0}\",\"switch_it_to_or\":\"switch it to {0} or {1}\",\"alarm_0x\":\"alarm {0} (0x{1})\",\"refused_or_broken_off_without\":\"refused or broken off without a reason; the vehicle is in {0}\",\"refused_or_broken_off_without_2\":\"refused or broken off without a reason; the vehicle is {0}\",\"an_undefined_mode\":\"an undefined mode\",\"an_undefined_mode_2\":\"an undefined mode, {0}\",\"servos_off\":\"servos off\",\"home_not_known\":\"home not known\",\"not_all_devices_at_home\":\"not all devices at home\",\"servos_off_2\":\"{0}, servos off\",\"home_not_known_2\":\"{0}, home not known\",\"not_all_devices_at_home_2\":\"{0}, not all devices at home\",\"servos_off_home_not_known\":\"{0}, servos off, home not known\",\"servos_off_not_all_devices\":\"{0}, servos off, not all devices at home\",\"home_not_known_not_all\":\"{0}, home not known, not all devices at home\",\"servos_off_home_not_known_2\":\"{0}, servos off, home not known, not all devices at home\",\"barcode_is_not_on_the\":\"barcode {0} is not on the map\",\"barcode_is_not_on_the_2\":\"barcode {0} is not on the map: check the dialect and the layout\",\"barcode_is_not_on_the_3\":\"barcode {0} is not on the map, but read with barcode_bytes {1} it would be {2}, which is: try dialect {3}\",\"itsc_has_no_command_of\":\"iTSC has no command of an AGV\",\"send_it_to_an_agv_2\":\"send it to an AGV\",\"a_port_needs_target_pulses\":\"a port needs target pulses\",\"teach_the_port_or_give\":\"teach the port, or give its pulses in the plant file\",\"alarm_0x_may_be_one\":\"alarm 0x{0} may be one of the vehicle's own\",\"choose_a_number_from_0x\":\"choose a number from 0x{0} to 0x{1}\",\"barcode_is_no_decimal_number\":\"barcode {0} is no decimal number without leading zeros\",\"write_it_in_the_plant\":\"write it in the plant file as the vehicle reports it, or choose a dialect with barcode_format ascii\",\"foreign_dev_id\":\"foreign DEV_ID\",\"the_vehicle_has_dev_id\":\"the vehicle has DEV_ID {0}, the packet {1}\",\"a_vehicle_sends_no_etb\":\"a vehicle sends no ETB packet\",\"another_epoch\":\"another epoch\",\"cmd_id_0x_was_given\":\"CMD_ID 0x{0} was given by another life of the controller\",\"code_0x_is_no_answer\":\"code 0x{0} is no answer and no event that is known\",\"status_answers_cmd_id_0x\":\"STATUS answers CMD_ID 0x{0}, which is not under way\",\"unasked_answer\":\"unasked answer\",\"cmd_id_0x_with_code\":\"CMD_ID 0x{0} with code 0x{1} is not under way\",\"code_0x_answers_code_0x\":\"code 0x{0} answers code 0x{1}\",\"unfit_answer\":\"unfit answer\",\"unfit_packet\":\"unfit packet\",\"unknown_code\":\"unknown code {0}\",\"is_no_format_of\":\"{0} is no format of {1}\",\"length_does_not_fit_elements\":\"LENGTH {0} does not fit {1} elements ({2})\",\"count_but_elements\":\"COUNT {0}, but {1} elements\",\"the_path_is_empty\":\"the path is empty\",\"the_first_seq_is_not\":\"the first SEQ is {0}, not 0\",\"seq_follows\":\"SEQ {0} follows {1}\",\"the_last_element_is_not\":\"the last element is not a stop\",\"is_not_printable_ascii\":\"{0} {1} is not printable ASCII\",\"seq_is_outside\":\"SEQ {0}: {1} is outside {2}..{3}\",\"move_needs_an_etb_packet\":\"MOVE needs an ETB packet\",\"xmove_needs_an_etb_packet\":\"XMOVE needs an ETB packet\",\"needs_an_etb_packet\":\"{0} needs an ETB packet\",\"does_not_travel_in_an\":\"{0} does not travel in an ETB packet\",\"does_not_fit_in_an\":\"{0} does not fit in an ENQ packet\",\"bytes_of_sub_data_at\":\"{0} bytes of sub data, at most {1} (max_sub)\",\"length_at_most_bytes_of\":\"LENGTH {0}: at most {1} bytes of sub data (max_sub)\",\"dev_id_does_not_fit\":\"DEV_ID {0} does not fit in 32 bits\",\"cmd_id_does_not_fit\":\"CMD_ID {0} does not fit in 64 bits\",\"a_field_of_the_header\":\"a field of the header does not fit\",\"of_bytes_then_silence\":\"{0} of {1} bytes, then silence\",\"length_is_more_than\":\"LENGTH {0} is more than {1}\",\"crc_expected\":\"{0}: CRC {1}, expected {2}\",\"etb_header_crc_expected\":\"ETB header: CRC {0}, expected {1}\",\"sub_packet_crc_expected\":\"sub packet: CRC {0}, expected {1}\",\"bytes_of_a_packet_then\":\"{0} bytes of a packet, then silence\",\"bytes_dropped\":\"{0} bytes dropped\",\"len_is_more_than\":\"LEN {0} is more than {1}\",\"byte_starts_no_packet\":\"byte {0} starts no packet\",\"len_is_not_from_1\":\"LEN {0} is not from 1 to {1}\",\"byte_stands_in_the_place\":\"byte {0} stands in the place of ETX\",\"crc_bytes_expected\":\"CRC bytes {0}, expected {1}\",\"unknown_command\":\"unknown command\",\"no_status_for_s\":\"no Status for {0} s\",\"the_link_is_down\":\"the link is down\",\"connect_it\":\"connect it\",\"it_has_not_reported_for\":\"it has not reported for a while\",\"see_whether_it_is_switched\":\"see whether it is switched on\",\"is_under_way\":\"{0} is under way\",\"wait_until_it_has_ended\":\"wait until it has ended\",\"overtaken_by\":\"overtaken by {0}\",\"it_has_not_ended_within\":\"it has not ended within {0} s\",\"status_shows_no_effect\":\"Status shows no effect\",\"see_whether_the_device_does\":\"see whether the device does what it is told\",\"it_reports_to_be_in\":\"it reports to be in position at tag {0}, not {1}\",\"the_agv_reports_an_error\":\"the AGV reports an error, last tag {0}\",\"the_agv_was_turned_to\":\"the AGV was turned to manual, last tag {0}\",\"it_stands_last_tag\":\"it stands, last tag {0}\",\"the_agv_reports_an_error_2\":\"the AGV reports an error\",\"the_lift_is_up_again\":\"the lift is up again\",\"the_lift_is_down_again\":\"the lift is down again\",\"the_lift_is_again\":\"the lift is {0} again\",\"the_buffer_reports_an_error\":\"the buffer reports an error\",\"the_door_reports_error\":\"the door reports error\",\"the_door_reports_open\":\"the door reports open\",\"the_door_reports_closed\":\"the door reports closed\",\"the_door_reports\":\"the door reports {0}\",\"it_reports_an_error\":\"it reports an error\",\"see_what_is_wrong_at\":\"see what is wrong at the device\",\"the_agv_is_in_error\":\"the AGV is in error\",\"see_what_is_wrong_at_2\":\"see what is wrong at the AGV, then Reset\",\"the_agv_does_not_stand\":\"the AGV does not stand still\",\"stop_it_first\":\"stop it first\",\"the_agv_is_in_manual\":\"the AGV is in manual\",\"the_agv_is_in_auto\":\"the AGV is in auto\",\"switch_it_to_manual_at\":\"switch it to manual at the AGV\",\"number_is_no_s_in\":\"{0}: number {1} is no {2}'s in this dialect\",\"two_devices_of_this_link\":\"{0}: two devices of this link have this name, or the number {1}\",\"connected_anew\":\"connected anew\",\"no_valid_packet_for_s\":\"no valid packet for {0} s\",\"is_not_on_this_link\":\"{0} is not on this link\",\"foreign_device\":\"foreign device\",\"device_is_not_configured_on\":\"device {0} is not configured on this link\",\"stx_without_a_packet_of\":\"STX without a packet of the specified form behind it\",\"the_packet_ends_in_neither\":\"the packet ends in {0}, neither ETX nor ETB\",\"bcc_expected\":\"BCC {0}, expected {1}\",\"packets_that_were_to_be\":\"{0} packets that were to be continued\",\"semi_step\":\"semi step\",\"auto_step\":\"auto step\",\"reciprocating_operation\":\"reciprocating operation\",\"is_no_whole_number_from\":\"{0} {1} is no whole number from 0 to {2}\",\"drive_address_is_not_from\":\"drive {0}: address {1} is not from 1 to {2}\",\"drive_its_name_or_its\":\"drive {0}: its name or its address {1} is on the line already\",\"another_master_is_on_the\":\"another master is on the line\",\"it_answers_nothing_that_was\":\"it answers nothing that was asked\",\"another_master_is_on_the_2\":\"{0}: another master is on the line\",\"it_answers_nothing_that_was_2\":\"{0}: it answers nothing that was asked\",\"stray_packet\":\"stray packet\",\"press_stop_reset_once_its\":\"press Stop/Reset once its cause is gone\",\"the_drive_did_not_answer\":\"the drive did not answer\",\"the_drive_is_in_error\":\"the drive is in error {0} {1}\",\"the_drive_took_the_command\":\"the drive took the command in mode error, where nothing moves\",\"the_drive_is_still_in\":\"the drive is still in error after Stop/Reset\",\"remove_the_cause_then_press\":\"remove the cause, then press it again\",\"the_status_does_not_show\":\"the status does not show whether the key was taken\",\"the_drive_did_not_take\":\"the drive did not take the key in {0} transmissions\",\"written_but_not_read_back\":\"written, but not read back: {0}\",\"written_but_not_read_back_2\":\"{0}: written, but not read back: {1}\",\"parameter_reads_back_as_not\":\"parameter {0} reads back as {1}, not {2}\",\"parameter_reads_back_as_not_2\":\"{0}: parameter {1} reads back as {2}, not {3}\",\"it_is_out_of_range\":\"it is out of range or read-only, or another parameter was written: compare them all\",\"write_them_one_by_one\":\"write them one by one\",\"the_jog_has_ended_but\":\"the jog has ended, but {0}\",\"the_drive_is_in_mode\":\"the drive is in mode {0}, not in jog\",\"the_drive_went_to_mode\":\"the drive went to mode {0} while jogging\",\"the_drive_did_not_take_2\":\"the drive did not take {0} jog keys on end\",\"another_jog_has_the_line\":\"another jog has the line\",\"wait_until_it_is_over\":\"wait until it is over\",\"there_is_no_such_drive\":\"there is no such drive\",\"drive_is_not_on_line\":\"drive {0} is not on line {1}\",\"line_is_down\":\"line {0} is down\",\"the_drive_is_offline\":\"the drive is offline\",\"switch_it_on_and_check\":\"switch it on and check its cable and its id\",\"only_one_drive_at_a\":\"only one drive at a time can answer\",\"ask_them_one_by_one\":\"ask them one by one\",\"in_error\":\"in error: {0}\",\"reset_them_first\":\"reset them first\",\"stop_reset_was_pressed\":\"Stop/Reset was pressed\",\"the_drive_is_busy_bsy\":\"the drive is busy: BSY to {0}\",\"no_answer_to_in_transmissions\":\"no answer to {0} in {1} transmissions\",\"no_answer_to_in_transmission\":\"no answer to {0} in {1} transmission\",\"no_answer_to_in_transmission_2\":\"no answer to {0} in {1} transmission; then no answer to {2} in {3} transmissions\",\"no_answer_to_in_transmissions_2\":\"no answer to {0} in {1} transmissions; then no answer to {2} in {3} transmissions\",\"nak_to_in_transmissions\":\"NAK to {0} in {1} transmissions\",\"nak_to_in_transmission\":\"NAK to {0} in {1} transmission\",\"then_the_drive_did_not\":\"then the drive did not answer\",\"the_drive_went_offline\":\"the drive went offline: {0}\",\"say_both_or_neither\":\"Say both, or neither.\",\"lies_outside\":\"{0}: lies outside {1} to {2}\",\"lies_outside_2\":\"lies outside {0} to {1}\",\"timezone_info\":\"{0}: has no zone: say it, such as 2026-07-01T08:30:00Z or 2026-07-01T17:30:00+09:00\",\"valid_datetime\":\"{0}: Input should be a valid datetime or date, {1}\",\"valid_boolean_2\":\"{0}: Input should be a valid boolean, unable to interpret input\",\"list_at_least\":\"{0}: List should have at least {1} item after validation, not {2}\",\"list_at_most\":\"{0}: List should have at most {1} items after validation, not {2}\",\"no_event_named\":\"{0}: there is no event {1}\",\"raw_unicode\":\"{0}: Input should be a valid string, unable to parse raw data as a unicode string\",\"a_sheet_reaches\":\"{0}: a sheet reaches to row {1}, column {2}\",\"delete_what_stands_far\":\"delete what stands far from the list, and save it anew\",\"0_or_1\":\"{0}' or '{1}\",\"0_input_should_be_a_finite\":\"{0}: Input should be a finite number\",\"no_colon_can_stand_here_put\":\"no colon can stand here: put a text that has one in quotes, or begin a new line\",\"no_value_begins_so_indent_with\":\"no value begins so: indent with blanks, not tabs, and put texts in quotes\",\"a_comma_is_missing_here_or\":\"a comma is missing here, or a bracket is not closed\",\"the_next_item_of_the_list\":\"the next item of the list is expected here, with its -: look at the indentation\",\"a_key_is_expected_here_look\":\"a key is expected here: look at the indentation\",\"a_text_in_quotes_is_not\":\"a text in quotes is not closed\",\"this_is_no_escape_in_double\":\"this is no escape in double quotes: a backslash itself is written twice\",\"a_colon_is_expected_behind_the\":\"a colon is expected behind the key\",\"a_tab_stands_where_blanks_indent\":\"a tab stands where blanks indent\",\"a_value_is_expected_here\":\"a value is expected here\",\"the_document_has_ended_before_this\":\"the document has ended before this\",\"this_character_is_none_that_a\":\"this character is none that a text may have\",\"a_list_begins_on_a_line\":\"a list begins on a line of its own\",\"a_mapping_begins_on_a_line\":\"a mapping begins on a line of its own\",\"this_cannot_stand_here_0\":\"this cannot stand here ({0})\",\"this_is_a_recording_get_api\":\"This is a recording: GET /api/v1/history?at=TIME shows what it has of a moment, GET /api/v1/history/span from when to when.\",\"the_name_0_is_not_found\":\"the name {0} is not found ({1})\",\"its_certificate_is_not_trusted_0\":\"its certificate is not trusted ({0})\",\"tls_is_not_agreed_on_0\":\"TLS is not agreed on ({0})\",\"no_connection_within_0_s\":\"no connection within {0} s\",\"0_refuses_the_connection\":\"{0} refuses the connection\",\"0_cannot_be_reached_1\":\"{0} cannot be reached ({1})\",\"the_connection_ended_without_an_answer\":\"the connection ended without an answer\",\"answered_0_1\":\"answered {0}: {1}\",\"answered_0\":\"answered {0}\",\"version_numbered\":\"version {0}\"}");
var events$1 = {
	"TransferInitiated": "Transfer initiated",
	"VehicleAssigned": "Vehicle assigned",
	"VehicleUnassigned": "Vehicle unassigned",
	"VehicleDeparted": "Vehicle departed",
	"VehicleArrived": "Vehicle arrived",
	"Transferring": "Transferring",
	"VehicleAcquireStarted": "Vehicle acquire started",
	"VehicleAcquireCompleted": "Vehicle acquire completed",
	"CarrierInstalled": "Carrier installed",
	"CarrierRemoved": "Carrier removed",
	"VehicleDepositStarted": "Vehicle deposit started",
	"VehicleDepositCompleted": "Vehicle deposit completed",
	"TransferCompleted": "Transfer completed",
	"TransferAbortInitiated": "Transfer abort initiated",
	"TransferAbortCompleted": "Transfer abort completed",
	"TransferAbortFailed": "Transfer abort failed",
	"TransferCancelInitiated": "Transfer cancel initiated",
	"TransferCancelCompleted": "Transfer cancel completed",
	"TransferCancelFailed": "Transfer cancel failed",
	"TransferPaused": "Transfer paused",
	"TransferResumed": "Transfer resumed",
	"AlarmSet": "Alarm set",
	"AlarmCleared": "Alarm cleared",
	"VehicleHeld": "Vehicle held",
	"VehicleReleased": "Vehicle released",
	"VehicleRemoved": "Vehicle removed",
	"VehicleInstalled": "Vehicle installed",
	"VehicleBrokenDown": "Vehicle broken down",
	"VehicleMended": "Vehicle mended",
	"TransferUpdated": "Transfer updated",
	"ControllerAuto": "Controller auto",
	"ControllerPausing": "Controller pausing",
	"ControllerPaused": "Controller paused",
	"PortStateChanged": "Port state changed",
	"CarrierLocationChanged": "Carrier location changed",
	"TeachingApproved": "Teaching approved",
	"PlaceClosing": "Place closing",
	"TeachingSessionOpened": "Teaching session opened",
	"ZoneResumed": "Zone resumed",
	"TeachingSessionEnded": "Teaching session ended",
	"TeachingTaken": "Teaching taken",
	"DriveParameterWritten": "Drive parameter written",
	"DriveOnline": "Drive online",
	"TeachingImported": "Teaching imported",
	"DriveOffline": "Drive offline",
	"EmergencySet": "Emergency set",
	"PlaceClosed": "Place closed",
	"TeachingRejected": "Teaching rejected",
	"TeachingCodeUnknown": "Teaching code unknown",
	"EmergencyReleased": "Emergency released",
	"PlaceOpened": "Place opened",
	"TeachingRolledBack": "Teaching rolled back",
	"DeviceChanged": "Device changed",
	"DriveErrorCleared": "Drive error cleared",
	"ZonePaused": "Zone paused",
	"DriveErrorSet": "Drive error set",
	"WalkStarted": "Walk started",
	"WalkEnded": "Walk ended"
};
var pages$1 = {
	"mend_that_give_it_another": "mend that, give job {0} another destination, or press ‘Cancel’ at it",
	"this_is_a_recording_get_api": "This is a recording: the room ‘Playback’ shows what it has.",
	"log_in_or_send": "Log in.",
	"clear_the_cause_then_post": "clear the cause, then press ‘Recover from the alarm’ at {0}",
	"see_what_is_wrong_then": "see what is wrong, then press ‘Recover from the alarm’ at {0}",
	"mend_the_cause_then_post": "mend the cause, then press ‘Recover from the alarm’ at {0} again",
	"post_api_v_vehicles_recover": "press ‘Recover from the alarm’ at {0} again once it is back",
	"see_what_it_carries_put": "see what it carries, write it down under ‘A carrier is at a place’ in the room ‘Stations’, then release the vehicle with ‘What it reports is true: go on’",
	"look_there_then_put_api": "look there, then press ‘Write down’ at the station",
	"teach_it_post_api_v": "teach it in the room ‘Teaching’, or ‘Write by hand’ at {0}",
	"teach_it_post_api_v_teaching": "teach it in the room ‘Teaching’, or ‘Write by hand’ at {0}",
	"align_the_hoist_over_the": "align the hoist over the port, then press ‘Teach DEST’ or ‘Teach OFFSET’; or send single axes from the vehicle",
	"may_stand_at_where_a_pick": "{0} may stand at {1}, where a pick-up failed: look, then say at {2} under ‘Write down’ whether it is ‘Occupied’",
	"see_get": "see {0}",
	"post_api_v1_teaching_proposals": "press ‘Assign’ at proposal {0} with the station",
	"teach_at_a_reference_port": "teach {0} at a reference port, or ‘Write by hand’ at {1}",
	"teach_with_a_vehicle_of": "teach {0} with a vehicle of known OFFSET, or ‘Write by hand’ at {1}",
	"delete_api_v1_devices_pin": "press ‘Give back to the vehicles’ at {0} first",
	"see_get_api_v1_operations": "see {0} under ‘What was asked of it’ of the drive, or begin another",
	"delete_its_jog": "let go of the button of jog {0}",
	"stop_it_first_post_api": "press ‘Stop / reset’ at {0} first",
	"when_it_is_over_post": "when it is over, say so under ‘Plant…’",
	"use_a_new_for_a": "use a new {0} for a new job, or look at job {1} in the room ‘Jobs’",
	"if_a_carrier_is_there": "if a carrier is there, say so first under ‘A carrier is at a place’ in the room ‘Stations’",
	"post_api_v1_jobs_abort": "press ‘Abort’ at job {0}",
	"post_api_v1_jobs_cancel": "press ‘Cancel’ at job {0}",
	"see_get_api_v1_stations": "see in the room ‘Stations’ which it serves",
	"nobody_knows_where_is_put": "nobody knows where {0} is: write the place of {1} down under ‘A carrier is at a place’ in the room ‘Stations’",
	"post_api_v1_vehicles_recover": "press ‘Recover from the alarm’ at {0}",
	"post_api_v1_vehicles_release": "press ‘Release’ at {0}",
	"connect_them_or_post_api": "connect them, or release them with ‘It is off the rail’ or ‘It stands at a barcode’; with ‘What it reports is true: go on’ one that is connected and on hold",
	"end_what_closes_it_kept": "end what closes it: the room ‘Closures’ lists it under ‘Routes keep off’",
	"if_it_is_not_so": "if it is not so, press ‘Write down’ at {0}",
	"release_it_first_post_api": "say first under ‘Plant…’ that it is over",
	"name_another_one_or_have": "name another one, or have version {0} rejected in the room ‘Layout’",
	"put_it_back_into_the": "Put it back into the file; once it is off the rail release {0} with ‘It is off the rail’, then take it out.",
	"mend_the_receiver_then_patch": "mend the receiver, then switch webhook {0} on again in the room ‘Webhooks’",
	"get_api_v1_lists_them": "/api/v1/{0} lists them.",
	"get_api_v1_names_its": "/api/v1/{0} names its models.",
	"get_api_v1_says_since": "/api/v1/{0} says since when.",
	"see_get_api_v1": "See /api/v1/{0}.",
	"see_get_api_v1_2": "see /api/v1/{0}",
	"the_live_stream_is_at": "The page has the live stream itself.",
	"add_a_user_first_post": "Add a user first in the room ‘Users and keys’.",
	"get_one_with_get_api": "Save one under ‘Incident’ in the room ‘Playback’.",
	"delete_api_v1_keys_name": "A key is ended in the room ‘Users and keys’.",
	"wait_for_it_or_post": "Wait for it, or reject version {0} in the room ‘Layout’.",
	"reject_what_nobody_wants_any": "Reject what nobody wants any more in the room ‘Layout’.",
	"activate_that_one_post_api": "Activate version {0} in the room ‘Layout’.",
	"its_dest_counts_only_where": "its dest counts only where a database is made: teach it, or ‘Write by hand’ at the station",
	"its_dest_counts_only_where_2": "{0}; its dest counts only where a database is made: teach it, or ‘Write by hand’ at the station",
	"export_it_first_get_api": "export its {0} first in the room ‘Teaching’, and keep the name if it is the same place or machine",
	"back_it_up_first_post": "press ‘Back up’ at the drive first",
	"tell_where_it_is_put": "tell where it is under ‘A carrier is at a place’ in the room ‘Stations’",
	"take_it_off_the_rail": "take it off the rail, then release {0} with ‘It is off the rail’",
	"patch_api_v1_stations_with": "write ‘Out of service’ at {0} under ‘Write down’ first; teach it anew afterwards",
	"look_where_it_stands_then": "look where it stands, then release it with ‘What it reports is true: go on’",
	"look_where_it_stands_bring": "look where it stands, bring it to a barcode it reads, then release it with ‘What it reports is true: go on’",
	"look_where_it_stands_release": "look where it stands; release it with ‘What it reports is true: go on’ if the barcode is right",
	"release_it_with_verdict_go": "release it with ‘What it reports is true: go on’ if it stands on the rail again",
	"see_that_the_carrier_stands": "see that the carrier stands where it should, then release the vehicle with ‘What it reports is true: go on’",
	"find_the_carrier_correct_its": "find the carrier, correct its place, then release the vehicle with ‘What it reports is true: go on’ (its job will fail)",
	"compare_its_place_load_and": "compare its place, load and job with the plant, correct them, then release it with ‘What it reports is true: go on’",
	"stop_it_then_release_it": "stop it, then release it with ‘What it reports is true: go on’ where it stands",
	"use_go_on": "release it with ‘What it reports is true: go on’",
	"send_stop_first_it_brings": "press ‘Stop (to MANT)’ first: it brings the vehicle to MANT",
	"send_stop": "press ‘Stop (to MANT)’",
	"let_a_person_look_at": "let a person look at the vehicle, then tick ‘I have looked: homing is safe’",
	"bring_to_barcode_send_it": "bring {0} to barcode {1}: ‘Move’, with ‘Stops for’ ‘Port’",
	"bring_it_to_barcode_in": "bring it to barcode {0}: in AUTO by ‘Move’ with ‘Stops for’ ‘Port’, then press ‘Stop (to MANT)’",
	"send_the_header_x_actor": "Write your name at the top right (‘Your name’).",
	"leave_action_out_or_send": "choose ‘nothing’ under ‘Stops for’",
	"send_move_to_one_of": "‘Move’ it to one of {0} first",
	"send_move_to_a_tag": "‘Move’ it to a tag; or let the others be taken off the floor (‘It is off the rail’)",
	"send_move_to_it_leads": "‘Move’ it to {0}: that leads there tag by tag",
	"wait_or_send_move_to": "wait, or ‘Move’ it to {0}: that goes as far as it may",
	"send_move_with_the_barcode": "use ‘Move’ with the barcode",
	"send_move_to_with_action": "‘Move’ it to {0} first, with ‘Stops for’: {1}",
	"send_servo_on_search_home": "press ‘Servo on’, ‘Search home’ and ‘Auto’, or ‘Recover from the alarm’",
	"leave_vehicle_out": "leave the vehicle out",
	"leave_vehicle_out_only_a": "leave the vehicle out: only a job that is queued or waiting can get another",
	"leave_carrier_out": "leave the carrier out",
	"has_its_lift_neither_up": "has its lift neither up nor down: wait for it, or press ‘Lift up’ or ‘Lift down’",
	"leave_expires_out_and_open": "leave ‘Minutes’ empty, and open it when everybody is out",
	"look_there_and_enter_it": "look there and enter it, or accept only what was seen",
	"to_take_the_files_put": "to take the file's, ‘Write by hand’ at {1}: {3}"
};
var names$1 = {
	"axis_drive_of_the_demo_plant": "Axis drive of the demo plant",
	"acceleration_time": "Acceleration time",
	"from_rest_to_the_maximum_speed": "From rest to the maximum speed",
	"deceleration_time": "Deceleration time",
	"from_the_maximum_speed_to_rest": "From the maximum speed to rest",
	"quick_stop_time": "Quick stop time",
	"s_curve": "S-curve",
	"maximum_speed": "Maximum speed",
	"minimum_speed": "Minimum speed",
	"run_speed": "Run speed",
	"jog_speed": "Jog speed",
	"home_search_speed": "Home search speed",
	"home_creep_speed": "Home creep speed",
	"home_direction": "Home direction",
	"cw": "CW",
	"ccw": "CCW",
	"home_offset": "Home offset",
	"right_soft_limit": "Right soft limit",
	"left_soft_limit": "Left soft limit",
	"in_position_window": "In-position window",
	"mark_sensor_delay": "Mark sensor delay",
	"mark_distance": "Mark distance",
	"index_distance": "Index distance",
	"step_0_position": "Step 0 position",
	"step_1_position": "Step 1 position",
	"step_2_position": "Step 2 position",
	"step_3_position": "Step 3 position",
	"step_0_dwell": "Step 0 dwell",
	"step_1_dwell": "Step 1 dwell",
	"step_2_dwell": "Step 2 dwell",
	"step_3_dwell": "Step 3 dwell",
	"motor_rated_current": "Motor rated current",
	"overload_limit": "Overload limit",
	"torque_boost": "Torque boost",
	"carrier_frequency": "Carrier frequency",
	"communication_id": "Communication id",
	"communication_speed": "Communication speed",
	"output_current": "Output current",
	"now": "Now",
	"dc_link_voltage": "DC link voltage",
	"heat_sink_temperature": "Heat sink temperature",
	"hours_in_operation": "Hours in operation",
	"last_error": "Last error",
	"firmware_version": "Firmware version",
	"merge_of_the_eastern_short_cut": "Merge of the eastern short cut",
	"merge_of_the_western_short_cut": "Merge of the western short cut",
	"way_into_bay_a": "Way into bay A",
	"merge_of_bay_a_s_parking_lane": "Merge of bay A's parking lane",
	"way_out_of_bay_a": "Way out of bay A",
	"way_into_bay_b": "Way into bay B",
	"merge_of_bay_b_s_parking_lane": "Merge of bay B's parking lane",
	"way_out_of_bay_b": "Way out of bay B",
	"merge_of_the_hall_s_middle_lane": "Merge of the hall's middle lane",
	"lift_of_stocker_stk01": "Lift of stocker STK01",
	"fork_of_stocker_stk01": "Fork of stocker STK01",
	"turntable_of_sort01": "Turntable of SORT01",
	"shutter_of_the_clean_room": "Shutter of the clean room",
	"east_curve": "East curve"
};
// ../app/texts/ko.json
var page = /*#__PURE__*/ JSON.parse("{\"live\":\"실시간\",\"connecting\":\"연결 중\",\"lost\":\"재연결 중\",\"lost_age\":\"재연결 중 · {0}초 전 데이터\",\"lost_none\":\"서버가 응답하지 않습니다. 다시 시도합니다\",\"controller\":\"제어기\",\"auto\":\"자동\",\"pausing\":\"일시정지 중\",\"waiting_for\":\"점호: {0} 대기\",\"vehicles\":\"차량\",\"choose_vehicle\":\"차량 선택…\",\"jobs\":\"작업\",\"open_jobs\":\"진행 작업\",\"open\":\"진행\",\"ended\":\"종료\",\"all\":\"전체\",\"reason_first\":\"사유를 먼저 입력하세요.\",\"stopped_here\":\"화면에서 정지\",\"behind_it\":\"근본 원인:\",\"wait_behind\":\"이 차량 때문에 {0}대 대기 중\",\"wait_for_it\":\"대기 차량\",\"no_match\":\"조건에 맞는 작업이 없습니다.\",\"no_marks\":\"이 기간에 알람·폐쇄·일시정지가 없습니다.\",\"no_jobs\":\"작업이 없습니다.\",\"events\":\"이벤트\",\"no_events\":\"아직 이벤트가 없습니다.\",\"new_transfer\":\"새 반송\",\"source\":\"출발\",\"destination\":\"도착\",\"carrier\":\"캐리어\",\"carrier_optional\":\"현재 캐리어\",\"priority\":\"우선순위\",\"order\":\"등록\",\"ordering\":\"등록 중…\",\"ordered\":\"작업 {0} 접수됨\",\"choose\":\"선택…\",\"ports\":\"포트\",\"buffers\":\"사이드 버퍼\",\"agv_buffers\":\"AGV 버퍼\",\"loaded_vehicles\":\"적재 차량\",\"cancel\":\"취소\",\"abort\":\"중단\",\"sure\":\"확인?\",\"close\":\"닫기\",\"fit\":\"전체 보기\",\"zoom_in\":\"확대\",\"zoom_out\":\"축소\",\"map\":\"지도\",\"state\":\"상태\",\"activity\":\"동작\",\"mode\":\"모드\",\"oper\":\"운전\",\"place\":\"위치\",\"job\":\"작업\",\"goal\":\"목표\",\"link\":\"링크\",\"link_up\":\"{0}부터 연결\",\"link_down\":\"{0}부터 끊김\",\"round_trip\":\"왕복 시간\",\"frames_io\":\"프레임 수신 / 송신\",\"trouble_counts\":\"손상 / 재전송 / 중복\",\"seen\":\"최근 상태 보고\",\"ago\":\"{0} 전\",\"dialect\":\"프로토콜 변형\",\"address\":\"주소\",\"none\":\"없음\",\"empty\":\"비어 있음\",\"loaded\":\"적재\",\"unknown\":\"모름\",\"waits\":\"대기\",\"held_note\":\"보류\",\"held\":\"보류\",\"locked\":\"{0} 정비 잠금\",\"hold\":\"보류\",\"release\":\"해제\",\"reason_of_end\":\"취소·중단 사유\",\"may_be_empty\":\"작업에 남음 (선택)\",\"reason\":\"사유\",\"verdict\":\"확인 결과\",\"verdict_go_on\":\"보고가 맞음: 계속\",\"verdict_off_rail\":\"레일에서 제거됨\",\"verdict_stands_at\":\"바코드 위치에 서 있음\",\"barcode\":\"바코드\",\"your_name\":\"이름\",\"name_hint\":\"모든 요청에 기록됩니다\",\"status_bits\":\"상태 비트\",\"status\":\"상태 보고 내용\",\"tag\":\"태그\",\"last_tag\":\"마지막 태그\",\"beyond\":\"정지 전 이동 목표\",\"charges_now\":\"충전 중\",\"cart\":\"카트\",\"lift\":\"리프트\",\"steering\":\"방향\",\"in_position\":\"정위치\",\"path\":\"수락한 이동\",\"agv_none\":\"없음\",\"agv_present\":\"있음\",\"agv_unknown\":\"모름\",\"agv_up\":\"상승\",\"agv_down\":\"하강\",\"agv_straight\":\"직진\",\"agv_left\":\"좌\",\"agv_right\":\"우\",\"agv_mark_stop\":\"마크 정지\",\"no_status\":\"상태 보고 없음\",\"last_frames\":\"최근 프레임\",\"no_frames\":\"통신 없음\",\"kind\":\"종류\",\"port\":\"포트\",\"sbfl\":\"좌측 사이드 버퍼\",\"sbfr\":\"우측 사이드 버퍼\",\"agv_buffer\":\"AGV 버퍼\",\"present\":\"점유\",\"yes\":\"예\",\"no\":\"아니오\",\"believed\":\"추정\",\"verified\":\"확인됨\",\"provenance\":\"근거\",\"host\":\"호스트\",\"placed\":\"차량이 내려놓음\",\"picked\":\"차량이 가져감\",\"person\":\"작업자\",\"inferred\":\"추론\",\"sensor\":\"센서\",\"plant\":\"플랜트 파일\",\"reserved\":\"예약\",\"out_of_service\":\"사용 중지\",\"target\":\"목표 펄스\",\"use_source\":\"여기서 출발\",\"use_destination\":\"여기로 도착\",\"key_title\":\"접근 키가 필요합니다\",\"key_label\":\"접근 키\",\"key_hint\":\"이 탭에만 저장되며 닫으면 지워집니다.\",\"key_use\":\"사용\",\"log_in\":\"로그인\",\"log_in_title\":\"로그인\",\"log_in_again\":\"다시 로그인하십시오\",\"nothing_lost\":\"서버가 누구인지 다시 묻습니다. 쓰던 내용은 그대로 있습니다.\",\"log_in_as_other\":\"다른 사람으로 로그인\",\"log_out\":\"로그아웃\",\"password\":\"암호\",\"use_a_key\":\"대신 키 사용\",\"use_password\":\"대신 이름과 암호 사용\",\"account\":\"현재 사용자\",\"roles\":\"역할\",\"good_until\":\"다시 로그인할 시각\",\"machine_key\":\"기계의 키\",\"change_password\":\"암호 변경\",\"old_password\":\"이전 암호\",\"new_password\":\"새 암호\",\"password_rule\":\"10자 이상\",\"password_changed\":\"새 암호가 적용되었습니다\",\"needs_role\":\"{0} 역할이 필요합니다. 지금은 {1}, 역할: {2}.\",\"role_viewer\":\"보기\",\"role_operator\":\"운전원\",\"role_maintenance\":\"정비\",\"role_mes\":\"MES\",\"role_admin\":\"관리자\",\"access\":\"사용자와 키\",\"users\":\"사용자\",\"machine_keys\":\"키\",\"no_users\":\"아직 추가된 사용자가 없어 로그인하지 않아도 됩니다. 첫 사용자는 관리자여야 합니다.\",\"no_keys\":\"키가 없습니다.\",\"disabled\":\"사용 중지\",\"enabled\":\"로그인 가능\",\"disable\":\"사용 중지\",\"enable\":\"다시 허용\",\"logged_in\":\"마지막 로그인\",\"never\":\"없음\",\"added\":\"추가\",\"change_roles\":\"역할 변경\",\"reset_password\":\"새 암호 부여\",\"password_reset\":\"{0}: 새 암호가 적용되고 로그아웃되었습니다\",\"add_user\":\"사용자 추가\",\"user_added\":\"{0}: 이제 로그인할 수 있습니다\",\"expires\":\"만료\",\"last_used\":\"마지막 사용\",\"revoke\":\"폐기\",\"key_revoked\":\"{0}: 더 이상 유효하지 않습니다\",\"key_active\":\"유효\",\"key_expired\":\"만료됨\",\"key_revoked_state\":\"폐기됨\",\"issue_key\":\"키 발급\",\"days_good\":\"일수\",\"until_revoked\":\"폐기할 때까지\",\"new_key\":\"새 키\",\"shown_once\":\"지금 복사하십시오. 다시 표시되지 않습니다.\",\"copy\":\"복사\",\"copied\":\"복사됨\",\"put_away\":\"닫기\",\"audit\":\"감사 기록\",\"no_rows\":\"해당하는 기록이 없습니다.\",\"check_chain\":\"위·변조 확인\",\"chain_looking\":\"{0}행 확인…\",\"chain_whole\":\"온전함: {0}행, #{1}까지, 해시 {2}…\",\"chain_broken\":\"#{0}에서 끊어짐: {1}\",\"what\":\"작업 내용\",\"on_what\":\"대상\",\"in_words\":\"내용\",\"carried_out\":\"수행\",\"since_when\":\"시작\",\"until_when\":\"끝\",\"newer\":\"최근\",\"page_number\":\"{0}쪽\",\"walks\":\"재고 실사\",\"no_walks\":\"실사가 없습니다.\",\"choose_walk\":\"실사를 시작하거나 선택하세요.\",\"begin_walk\":\"실사 시작\",\"all_buffers\":\"모든 사이드 버퍼\",\"entered\":\"입력\",\"begun\":\"시작\",\"walk_open\":\"진행 중\",\"walk_accepted\":\"확정\",\"walk_abandoned\":\"포기\",\"finding\":\"결과\",\"found_not_seen\":\"미확인\",\"found_differs\":\"다름\",\"found_moved\":\"이후 변동\",\"found_agrees\":\"일치\",\"places\":\"장소\",\"expected\":\"예상\",\"found\":\"실제\",\"enter\":\"입력\",\"full\":\"있음\",\"unread\":\"ID 미확인\",\"entered_place\":\"{0} 입력됨\",\"read_csv\":\"CSV 읽기\",\"walk_file_columns\":\"파일에 station과 seen(full 또는 empty) 열이 필요하며 seen_carrier는 선택입니다. 목록을 CSV로 저장해 채우십시오.\",\"walk_file_word\":\"{0}행: seen은 full, empty 또는 빈칸이어야 합니다. “{1}”은 안 됩니다.\",\"walk_file_nothing\":\"파일에 확인된 내용이 없습니다.\",\"walk_file_read\":\"파일에서 {0}곳 입력됨\",\"accept\":\"확정\",\"accept_partial\":\"확인된 것만 확정\",\"walk_doubtful\":\"{0}곳은 미확인이거나 이후 변동되어 그대로 둡니다.\",\"stations_cut_off\":\"도달 불가 {0}곳\",\"cut_off_now\":\"도달할 수 없는 스테이션\",\"kept_off\":\"경로가 피하는 곳\",\"not_reachable\":\"도달할 수 없음:\",\"since_start\":\"시작 이후\",\"led_round\":\"폐쇄 구간 우회 {0}대\",\"led_quicker\":\"더 빠른 길로 {0}대\",\"slow_track\":\"현재 혼잡 구간 {0}개\",\"restrained_to\":\"현재 작업 중 주행 호이스트 최대 {0}대\",\"weighed\":\"경로 재평가 {0}회\",\"closed_before\":\"이전 폐쇄\",\"watch\":\"실시간 관찰\",\"watch_begin\":\"관찰 시작\",\"watch_end\":\"종료\",\"watch_hint\":\"한 번에 {0}개까지\",\"inputs\":\"상태와 입력\",\"ask_status\":\"상태 요청\",\"input_run\":\"운전\",\"input_home\":\"원점\",\"inputs_off\":\"모든 입력 끄기\",\"operations\":\"요청 이력\",\"no_operations\":\"요청 이력이 없습니다.\",\"op_state_done\":\"완료\",\"op_state_failed\":\"실패\",\"op_state_running\":\"진행 중\",\"op_state_unknown\":\"알 수 없음\",\"last_commands\":\"최근 명령\",\"no_commands\":\"명령 없음\",\"lines\":\"회선\",\"no_lines\":\"여러 장치를 연결한 회선이 없습니다.\",\"stop_line\":\"이 회선의 드라이브 모두 정지\",\"line_stopped\":\"모두에 정지를 보냈습니다\",\"stage\":\"차량 미리 보내기\",\"nearest_free\":\"가장 가까운 빈 차량\",\"staged\":\"가는 중입니다\",\"park\":\"주차\",\"tell_fire\":\"화재 발생\",\"tell_earthquake\":\"지진 발생\",\"webhooks\":\"웹훅\",\"no_webhooks\":\"HTTP로 알리는 곳이 없습니다.\",\"behind\":\"지연\",\"delivered\":\"전달\",\"failing_since\":\"실패 시작\",\"hook_active\":\"동작 중\",\"hook_paused\":\"일시정지\",\"hook_failed\":\"중단됨\",\"told_up_to\":\"전달 위치\",\"ping\":\"시험 전송\",\"pinged\":\"수신되었습니다\",\"new_secret\":\"새 비밀 값\",\"both_sign\":\"하루 동안 두 비밀 값으로 서명합니다\",\"replay_after\":\"다시 보낼 이벤트 번호(이후)\",\"replay\":\"다시 전달\",\"secret\":\"비밀 값\",\"deliveries\":\"전달 이력\",\"subscribe\":\"알림 추가\",\"begin_after\":\"이벤트 번호 이후\",\"from_now\":\"지금부터\",\"teaching_files\":\"파일\",\"teaching_raw\":\"원시 이벤트\",\"dests_of_ports\":\"포트 DEST\",\"offsets_of_vehicles\":\"차량 OFFSET\",\"save_json\":\"JSON 저장\",\"save_history\":\"전체 버전 저장\",\"read_file\":\"파일 읽기\",\"imported\":\"가져왔습니다\",\"import\":\"가져오기\",\"import_wrong\":\"잘못된 행이 있으면 가져올 수 없습니다.\",\"import_ready\":\"{0}을(를) 확인했습니다. 아직 바뀐 것은 없습니다.\",\"import_none\":\"파일을 읽으면 각 행의 결과가 먼저 표시됩니다.\",\"line_of_file\":\"행\",\"fate_new\":\"신규\",\"fate_changed\":\"변경\",\"fate_same\":\"동일\",\"fate_error\":\"오류\",\"teaching_events\":\"차량이 보낸 값\",\"position\":\"위치\",\"from_start\":\"처음부터\",\"compare_offsets\":\"두 차량의 OFFSET 비교\",\"vehicle_other\":\"다른 차량\",\"difference\":\"차이\",\"write_by_hand\":\"직접 입력\",\"legend_carrier\":\"캐리어\",\"legend_zone\":\"정지 금지 구역\",\"legend_door\":\"도어 닫힘, 열림\",\"look_idle\":\"유휴\",\"look_moving\":\"이동\",\"look_waiting\":\"대기\",\"look_handling\":\"적재·하역\",\"look_charging\":\"충전\",\"look_held\":\"보류\",\"look_alarm\":\"알람\",\"look_gone\":\"부재\",\"idle\":\"유휴\",\"moving\":\"이동 중\",\"waiting\":\"대기\",\"busy\":\"작업 중\",\"settling\":\"확인 중\",\"absent\":\"응답 없음\",\"off_rail\":\"레일 밖\",\"locked_out\":\"정비 잠금\",\"recovering\":\"복구 중\",\"alarm\":\"알람\",\"charging\":\"충전 중\",\"acquiring\":\"적재 중\",\"depositing\":\"하역 중\",\"paused\":\"일시정지\",\"removed\":\"제거됨\",\"not_assigned\":\"미할당\",\"enroute\":\"이동 중\",\"parked\":\"정차\",\"queued\":\"대기열\",\"transferring\":\"반송 중\",\"cancelling\":\"취소 중\",\"aborting\":\"중단 중\",\"completed\":\"완료\",\"failed\":\"실패\",\"cancelled\":\"취소됨\",\"aborted\":\"중단됨\",\"in_service\":\"사용 중\",\"devices\":\"장치\",\"door\":\"도어\",\"buffer\":\"버퍼\",\"charger\":\"충전기\",\"device_open\":\"열림\",\"device_closed\":\"닫힘\",\"device_cart\":\"카트 있음\",\"device_no_cart\":\"카트 없음\",\"device_charging\":\"충전 중\",\"device_free\":\"비어 있음\",\"device_busy\":\"동작 중\",\"device_unknown\":\"상태 모름\",\"device_error\":\"오류\",\"device_silent\":\"응답 없음\",\"since\":\"{0}부터\",\"last_word\":\"마지막 상태: {0}\",\"passing\":\"통과 차량\",\"charges\":\"충전 차량\",\"nobody\":\"없음\",\"lock_for\":\"잠금 요청자\",\"lock_unsure\":\"확인되지 않음\",\"not_locked\":\"잠금 없음\",\"pinned\":\"{1} 님이 {0} 상태로 유지\",\"pending\":\"진행 중 명령\",\"contradicts\":\"기록과 다름\",\"at_station\":\"스테이션\",\"on_line\":\"라인\",\"line_number\":\"{0} · 번호 {1}\",\"cmd_open\":\"도어 열기\",\"cmd_close\":\"도어 닫기\",\"cmd_lock\":\"잠금\",\"cmd_unlock\":\"잠금 해제\",\"asked\":\"요청됨: {0}\",\"drives\":\"드라이브\",\"drive\":\"드라이브\",\"drive_parameter_select\":\"파라미터 선택\",\"drive_parameter_value\":\"파라미터 설정\",\"drive_monitoring\":\"모니터링\",\"drive_jog\":\"조그\",\"drive_error\":\"오류\",\"drive_offline\":\"오프라인\",\"drive_not_heard\":\"아직 응답 없음\",\"drive_online\":\"온라인\",\"error_fact\":\"오류\",\"operation_fact\":\"운전 방식\",\"output\":\"출력\",\"turn\":\"회전 방향\",\"cw\":\"시계 방향\",\"ccw\":\"반시계 방향\",\"distance\":\"이동 거리\",\"model\":\"모델\",\"moves\":\"움직임\",\"stop_reset\":\"정지 / 리셋\",\"parameters\":\"파라미터\",\"read_parameters\":\"파라미터 읽기\",\"reading\":\"{1}개 중 {0}개 읽음\",\"no_parameters\":\"아직 읽지 않음\",\"op_done\":\"{0}: 완료\",\"op_running\":\"{0}: 요청됨\",\"op_unknown\":\"적용 여부를 알 수 없음\",\"no_model\":\"없음: 번호로만 파라미터 접근\",\"map_label\":\"트랙 지도. 드래그로 이동, 휠로 확대, 알고 싶은 것을 클릭하세요.\",\"vehicle\":\"차량\",\"alarms\":\"알람\",\"no_alarms\":\"이상이 없습니다.\",\"rooms\":\"화면\",\"find\":\"찾기\",\"nothing_found\":\"일치하는 항목 없음\",\"filter\":\"필터\",\"more_rows\":\"{0}개 더 있음\",\"show_more\":\"더 보기\",\"layers\":\"레이어\",\"layer_grants\":\"허가된 경로\",\"layer_zones\":\"구역\",\"layer_closures\":\"폐쇄\",\"layer_holds\":\"보류·정비 잠금\",\"heat\":\"히트맵\",\"heat_over\":\"집계 기간\",\"heat_hours\":\"최근 {0}시간\",\"heat_seen\":\"페이지를 연 이후\",\"heat_off\":\"없음\",\"heat_waiting\":\"대기 시간\",\"heat_traffic\":\"통행량\",\"little\":\"적음\",\"much\":\"많음\",\"follow\":\"따라가기\",\"follow_hint\":\"선택한 차량을 가운데에 유지 (F)\",\"keys\":\"지도 단축키\",\"key_find\":\"찾기\",\"key_pan\":\"지도 이동\",\"key_zoom\":\"확대·축소\",\"key_fit\":\"전체 보기\",\"key_follow\":\"선택한 차량 따라가기\",\"key_none\":\"선택 해제\",\"legend_soft\":\"완화 구역\",\"theme_light\":\"밝은 화면\",\"theme_dark\":\"어두운 화면\",\"idle_parked\":\"유휴, 주차\",\"why\":\"사유\",\"circle\":\"호이스트 순환 대기\",\"circles_counted\":\"시작 이후 발견 {0}, 해소 {1}\",\"job_details\":\"작업 상세\",\"fallbacks\":\"대체 {0}\",\"wished\":\"지정 차량: {0}\",\"ordered_by\":\"등록자\",\"ordered_at\":\"등록 시각\",\"result\":\"결과\",\"phases\":\"단계별 소요 시간\",\"phase_queued\":\"대기\",\"phase_fetching\":\"출발지 이동\",\"phase_carrying\":\"운반\",\"why_vehicle\":\"왜 이 차량인가\",\"not_assigned_yet\":\"아직 배정된 차량이 없습니다.\",\"why_waits\":\"무엇을 기다렸나\",\"never_waited\":\"기다리지 않았습니다.\",\"still\":\"계속\",\"left_out\":\"처음과 최근 사이 {0}건 생략\",\"to_source\":\"출발지까지 {0}\",\"hot_lot\":\"긴급 로트\",\"instead_of\":\"{0} 대신: {1} 가까움\",\"worth\":\"대기 가산 {0}, 변경 최소 이득 {1}\",\"no_way\":\"경로 없음\",\"change\":\"변경\",\"any\":\"아무 차량\",\"taken\":\"완료\",\"older\":\"이전 작업\",\"takes\":\"소요\",\"device\":\"장치\",\"commands\":\"명령\",\"sent\":\"전송됨\",\"recover\":\"알람 복구\",\"homing_safe\":\"확인함: 원점 복귀가 안전함\",\"vc_status\":\"상태 요청\",\"vc_stop_by_host\":\"호스트 정지\",\"vc_stop\":\"정지 (MANT)\",\"vc_auto\":\"자동\",\"vc_alarm_clear\":\"알람 해제\",\"vc_servo_on\":\"서보 켜기\",\"vc_servo_off\":\"서보 끄기\",\"vc_search_home\":\"원점 탐색\",\"vc_go_home\":\"원점 이동\",\"vc_system_reset\":\"시스템 리셋\",\"vc_agv_mark_stop\":\"마크 정지\",\"vc_lift_up\":\"리프트 상승\",\"vc_lift_down\":\"리프트 하강\",\"vc_lift_stop\":\"리프트 정지\",\"vc_charge_on\":\"충전 시작\",\"vc_charge_off\":\"충전 종료\",\"speed\":\"속도\",\"speed_slow\":\"느리게\",\"speed_normal\":\"보통\",\"speed_fast\":\"빠르게\",\"at_forks\":\"갈림길에서\",\"by_hand\":\"수동, 정지할 때까지\",\"hand_forward\":\"수동: 앞으로\",\"hand_backward\":\"수동: 뒤로\",\"hand_turn_left\":\"수동: 왼쪽 회전\",\"hand_turn_right\":\"수동: 오른쪽 회전\",\"tape_forward\":\"테이프 따라 앞으로\",\"tape_backward\":\"테이프 따라 뒤로\",\"agv_alias\":\"이름으로 목적지 이동\",\"stands_at_tag\":\"현재 태그\",\"tell_it\":\"알리기\",\"vc_pickup\":\"적재\",\"vc_place\":\"하역\",\"vc_display\":\"표시\",\"display_text\":\"차량 표시 문구\",\"move\":\"이동\",\"move_to\":\"이동할 바코드\",\"stop_action\":\"정지 유형\",\"act_stop\":\"정지만\",\"lock_out\":\"정비 잠금\",\"lift_lockout\":\"정비 잠금 해제\",\"lockout\":\"정비 잠금\",\"take_out\":\"사용 중지\",\"put_back\":\"사용 재개\",\"decide\":\"조치\",\"unpin\":\"차량 제어로 되돌리기\",\"pin_open\":\"열린 상태 유지\",\"pin_closed\":\"닫힌 상태 유지\",\"closures\":\"폐쇄\",\"nothing_closed\":\"폐쇄된 곳이 없습니다.\",\"draining\":\"비우는 중\",\"closed\":\"폐쇄됨\",\"ends_in\":\"{0} 후 종료\",\"release_wished\":\"{0} 님이 해제 요청\",\"open_it\":\"해제\",\"pause\":\"일시정지\",\"resume\":\"재개\",\"stop_zone\":\"정지\",\"stopped\":\"정지됨\",\"close_place\":\"폐쇄\",\"close_stretch\":\"트랙 구간\",\"close_edge\":\"트랙 한 칸\",\"close_barcode\":\"바코드\",\"close_zone\":\"구역\",\"close_from\":\"시작 바코드\",\"close_to\":\"끝 바코드\",\"purpose\":\"목적\",\"traffic\":\"교통\",\"work\":\"작업자 작업\",\"minutes\":\"분\",\"until_opened\":\"해제할 때까지\",\"closes_now\":\"폐쇄됨 또는 비우는 중\",\"choose_on_map\":\"위 지도에서 트랙을 클릭하거나 바코드를 입력한 뒤 영향을 확인하세요.\",\"look_first\":\"먼저 영향을 확인하세요.\",\"preview\":\"영향 미리 보기\",\"stations_closed\":\"폐쇄되는 스테이션:\",\"cut_off\":\"도달 불가:\",\"drive_out\":\"빠져나와야 할 차량:\",\"shut_in\":\"갇히는 차량:\",\"jobs_touched\":\"작업 {0}건 영향\",\"routes_longer\":\"경로 {1}개 중 {0}개 길어짐\",\"routes_lost\":\"{0}개 끊김\",\"routes_mean\":\"평균 소요 {0}초 → {1}초\",\"stations\":\"스테이션\",\"carriers\":\"캐리어\",\"age\":\"경과\",\"remove\":\"삭제\",\"carrier_is\":\"캐리어 위치 기록\",\"write_down\":\"기록\",\"name\":\"이름\",\"teaching\":\"티칭\",\"proposals\":\"제안\",\"sessions\":\"세션\",\"drift\":\"편차\",\"dry_run\":\"모의 계산\",\"no_proposals\":\"아직 티칭 이력이 없습니다.\",\"no_sessions\":\"세션이 없습니다.\",\"no_drift\":\"이전 값과 크게 다른 항목이 없습니다.\",\"dest\":\"DEST\",\"offset\":\"OFFSET\",\"old\":\"이전\",\"new\":\"신규\",\"when\":\"시각\",\"who\":\"담당\",\"sent_positions\":\"수신 위치\",\"asked_by\":\"요청자\",\"assign\":\"지정\",\"approve\":\"승인\",\"approve_anyway\":\"그래도 승인\",\"reject\":\"반려\",\"teach_port\":\"포트 티칭\",\"open_session\":\"세션 열기\",\"close_session\":\"세션 닫기\",\"abandon\":\"포기\",\"teach_dest\":\"DEST 티칭\",\"teach_offset\":\"OFFSET 티칭\",\"reference_vehicle\":\"기준 차량: 0\",\"refused\":\"거부\",\"changes_nothing\":\"바뀌는 펄스가 없습니다.\",\"never_taught\":\"티칭된 적 없음.\",\"compare\":\"비교\",\"roll_back\":\"v{0}(으)로 되돌리기\",\"ready\":\"승인 대기\",\"collecting\":\"수집 중\",\"incomplete\":\"불완전\",\"approved\":\"승인됨\",\"rejected\":\"반려됨\",\"abandoned\":\"포기됨\",\"ambiguous\":\"포트 불명확\",\"wrong_mode\":\"모드 오류\",\"out_of_range\":\"범위 초과\",\"jog\":\"조그\",\"jog_hint\":\"누르는 동안만 동작\",\"backups\":\"백업·비교\",\"note\":\"메모\",\"back_up\":\"백업\",\"compare_with\":\"비교할 드라이브\",\"restore\":\"복원\",\"restore_dry\":\"복원 시험\",\"no_differences\":\"차이가 없습니다.\",\"write\":\"쓰기\",\"master\":\"플랜트…\",\"stop_all\":\"전체 정지\",\"release_fire\":\"화재 상황 해제\",\"release_earthquake\":\"지진 상황 해제\",\"more\":\"더 보기\",\"job_id\":\"작업 ID\",\"given_here\":\"자동 부여\",\"fallbacks_label\":\"대체 도착지(여럿)\",\"statistics\":\"통계\",\"period_hour\":\"1시간\",\"period_shift\":\"8시간\",\"period_day\":\"1일\",\"period_week\":\"7일\",\"save_csv\":\"CSV로 저장\",\"table_phases\":\"단계\",\"table_intervals\":\"구간\",\"table_vehicles\":\"차량\",\"table_waits\":\"대기\",\"table_places\":\"대기 장소\",\"table_late\":\"지연 작업\",\"table_open\":\"미완료 작업\",\"waits_by_place\":\"작업이 기다린 장소\",\"late_lots\":\"가장 늦은 작업\",\"open_at_end\":\"기간 종료 시점에 미완료인 작업\",\"longest_wait\":\"최장 대기\",\"waited_for\":\"대기 이유\",\"table_transfers\":\"반송\",\"report\":\"보고서\",\"queue\":\"대기열\",\"empty_travel\":\"공차 주행\",\"throughput\":\"처리량\",\"delivery_time\":\"반송 시간\",\"waits_by_cause\":\"원인별 대기\",\"utilisation\":\"가동률\",\"failures\":\"고장\",\"availability\":\"가용도\",\"phase\":\"단계\",\"count\":\"건수\",\"mean\":\"평균\",\"longest\":\"최장\",\"phase_acquiring\":\"적재\",\"phase_depositing\":\"하역\",\"phase_total\":\"전체\",\"alarms_now\":\"현재\",\"alarms_history\":\"이력\",\"alarms_pareto\":\"파레토\",\"known_to\":\"{0} 님이 {1}에 확인\",\"acknowledge\":\"확인\",\"no_alarms_yet\":\"알람 이력이 없습니다.\",\"cause\":\"원인\",\"pareto_code\":\"원인별\",\"pareto_source\":\"설비별\",\"pareto_both\":\"둘 다\",\"stage_file\":\"플랜트 파일 올리기\",\"what_differs\":\"달라지는 것\",\"text_not_kept\":\"거부된 뒤 다른 버전도 거부되어 파일 내용은 더 이상 보관되지 않습니다.\",\"jobs_refused_meanwhile\":\"그때까지 접수된 작업은 계속되며, 없어질 곳으로 또는 그곳에서 출발하는 새 작업은 거절됩니다.\",\"layouts\":\"레이아웃\",\"no_versions\":\"보관된 버전이 없습니다.\",\"version\":\"버전\",\"version_staged\":\"준비됨\",\"version_awaited\":\"적용 대기\",\"version_active\":\"운영 중\",\"version_former\":\"이전 버전\",\"version_rejected\":\"거부됨\",\"plant_file\":\"플랜트 파일 선택…\",\"version_taken\":\"보관했습니다. 플랜트는 그대로입니다.\",\"activate\":\"적용\",\"activate_later\":\"막는 것이 없어지면 적용\",\"roll_back_to\":\"이 버전으로 되돌리기\",\"take_back\":\"적용 취소\",\"save_file\":\"파일 저장\",\"in_the_way\":\"지금 막고 있는 것\",\"nothing_in_the_way\":\"막고 있는 것이 없습니다.\",\"lost_with_it\":\"더 이상 쓰이지 않게 되는 것\",\"lacking_with_it\":\"적용 뒤 티칭할 것\",\"no_difference\":\"운영 중인 버전과 차이가 없습니다.\",\"diff_added\":\"추가\",\"diff_removed\":\"삭제\",\"diff_changed\":\"변경\",\"diff_moved\":\"이동\",\"diff_renamed\":\"이름 변경\",\"how\":\"변화\",\"track\":\"트랙\",\"at\":\"시각\",\"actor\":\"누가\",\"playback\":\"재생\",\"loading\":\"불러오는 중…\",\"nothing_recorded\":\"아직 기록이 없습니다. 재생하려면 playback_days가 0보다 커야 합니다.\",\"past_recording\":\"기록된 사건\",\"past_here\":\"과거\",\"past_ago\":\"{0} 전\",\"past_by\":\"{0} 내보냄, {1}\",\"past_no_commands\":\"여기서는 명령할 수 없습니다.\",\"past_alarms_now\":\"현재 알람 {0}\",\"back_to_live\":\"실시간으로\",\"events_of_note\":\"주요 사건\",\"event_before\":\"이전 이벤트\",\"event_next\":\"다음 이벤트\",\"play\":\"재생\",\"stop_playing\":\"일시정지\",\"pace\":\"배속\",\"stretch\":\"표시 구간\",\"stretch_minutes\":\"10분\",\"stretch_hour\":\"1시간\",\"stretch_shift\":\"8시간\",\"stretch_day\":\"1일\",\"stretch_all\":\"전체\",\"moment\":\"시점\",\"link_hint\":\"이 시점의 주소를 복사합니다\",\"link_copy\":\"링크 복사\",\"link_copied\":\"복사됨\",\"incident\":\"사건\",\"from_moment\":\"부터\",\"to_moment\":\"까지\",\"take_moment\":\"표시된 시점 사용\",\"incident_save\":\"파일로 내보내기\",\"incident_hint\":\"다른 곳에서 열기: hoistway replay FILE\",\"saved_as\":\"{0}(으)로 저장됨\",\"not_then\":\"이 시점에 없거나 기록되지 않았습니다.\",\"granted\":\"허가 구간\",\"here\":\"여기\",\"legend_granted\":\"허가 구간\",\"legend_planned\":\"계획 경로\",\"newer_rows\":\"최근\",\"older_rows\":\"이전\",\"jobs_ordered\":\"접수\",\"vc_agv_stop\":\"정지\",\"bit_foup\":\"캐리어\",\"bit_trav\":\"주행\",\"bit_shft\":\"시프터\",\"bit_rota\":\"로테이터\",\"bit_lift\":\"리프터\",\"bit_slid\":\"슬라이더\",\"bit_grip\":\"그리퍼\",\"bit_sftb\":\"낙하 방지\",\"bit_mode\":\"모드\",\"bit_oper\":\"운전\",\"bit_at_barcode\":\"바코드 인식\",\"bit_all_home\":\"전체 원점\",\"bit_home_known\":\"원점 인식\",\"bit_servos_on\":\"전체 서보 온\",\"bit_rsv1\":\"예약\",\"bit_rsv2\":\"예약\",\"bit_alarm_code\":\"알람 코드\",\"bit_process_code\":\"공정 코드\",\"servo_not_ready\":\"서보 준비 안 됨\",\"servo_error\":\"서보 에러\",\"driver_error\":\"드라이버 에러\",\"driving\":\"구동 중\",\"front_bumper\":\"전방 범퍼 감지\",\"rear_bumper\":\"후방 범퍼 감지\",\"at_stop_tag\":\"포트 위치 정지\",\"at_sbfl\":\"좌측 버퍼 위치 정지\",\"at_sbfr\":\"우측 버퍼 위치 정지\",\"at_port_sbfl\":\"포트·좌측 버퍼 위치 정지\",\"at_port_sbfr\":\"포트·우측 버퍼 위치 정지\",\"at_sbfl_sbfr\":\"양쪽 버퍼 위치 정지\",\"at_port_sbfl_sbfr\":\"포트·양쪽 버퍼 위치 정지\",\"stop\":\"정지\",\"home\":\"원점\",\"left_limit\":\"좌측 리미트\",\"right_limit\":\"우측 리미트\",\"cw_limit\":\"시계 방향 리미트\",\"ccw_limit\":\"반시계 방향 리미트\",\"left_side\":\"좌측\",\"right_side\":\"우측\",\"left_destination\":\"좌측 목적 위치\",\"right_destination\":\"우측 목적 위치\",\"wide\":\"넓게 열림\",\"raised\":\"올림\",\"grip_open\":\"열림\",\"grip_close\":\"닫힘\",\"mant\":\"MANT, 정비\",\"semi\":\"SEMI, 반자동\",\"run\":\"동작 중\",\"pause_oper\":\"일시정지, 장애물\",\"cs_open\":\"진행 중\",\"cs_done\":\"완료\",\"cs_failed\":\"실패\",\"cs_unknown\":\"알 수 없음\",\"cs_not_sent\":\"전송 안 됨\",\"cs_settled_done\":\"완료, 상태로 확인\",\"cs_settled_not_done\":\"미완료, 상태로 확인\",\"vc_move\":\"이동\",\"vc_xmove\":\"이동 연장\",\"vc_open\":\"열기\",\"vc_close\":\"닫기\",\"vc_lock\":\"잠금\",\"vc_unlock\":\"잠금 해제\",\"vc_agv_charge\":\"충전\",\"vc_agv_lift\":\"리프트\",\"reliability\":\"신뢰성\",\"down_minutes\":\"정지 시간(분)\",\"failures_of\":\"고장 이력\",\"catalogue\":\"모델 카탈로그\",\"default_value\":\"기본값\",\"range\":\"범위\",\"read_only\":\"읽기 전용\",\"while_running\":\"운전 중 쓰기 가능\",\"description\":\"설명\",\"no_catalogue\":\"이 모델의 카탈로그가 없습니다. 파라미터는 번호로 다룹니다.\",\"backup_contents\":\"내용\",\"in_force\":\"현재 적용 값\",\"period_other\":\"직접 지정\",\"period_begin\":\"시작\",\"period_end\":\"끝\",\"file_kind\":\"파일 형식\",\"print_report\":\"보고서 열어 인쇄\",\"print\":\"인쇄\",\"count_connections\":\"연결\",\"count_frames_in\":\"수신 프레임\",\"count_frames_out\":\"송신 프레임\",\"count_garbled\":\"손상\",\"count_resends\":\"재전송\",\"count_sent\":\"전송\",\"count_answered\":\"응답\",\"count_timeouts\":\"시간 초과\",\"count_naks\":\"NAK\",\"count_busies\":\"사용 중\",\"count_strays\":\"요청하지 않은 응답\",\"normal\":\"정상\",\"keys_past\":\"재생 단축키\",\"period_month\":\"30일\",\"did_AbandonWalk\":\"재고 실사 포기\",\"did_AbortJob\":\"작업 중단\",\"did_AcceptWalk\":\"재고 실사 확정\",\"did_AcknowledgeAlarm\":\"알람 확인\",\"did_AddWebhook\":\"웹훅 추가\",\"did_ApproveProposal\":\"티칭 승인\",\"did_AskDriveStatus\":\"드라이브 상태 요청\",\"did_AssignProposal\":\"티칭 포트 지정\",\"did_BackUpDrive\":\"드라이브 백업\",\"did_CancelDriveOperation\":\"드라이브 작업 취소\",\"did_CancelJob\":\"작업 취소\",\"did_ChangeJob\":\"작업 변경\",\"did_ChangeWebhook\":\"웹훅 변경\",\"did_ClosePlace\":\"폐쇄\",\"did_CommandAgv\":\"AGV 명령\",\"did_CommandDevice\":\"장치 명령\",\"did_CommandVehicle\":\"차량 명령\",\"did_CompareDrive\":\"드라이브 비교\",\"did_CreateJob\":\"작업 등록\",\"did_DisplayOnVehicle\":\"차량 표시\",\"did_EndTeaching\":\"티칭 세션 닫기\",\"did_EnterSights\":\"실물 확인 입력\",\"did_HandleOnce\":\"단독 적재·하역\",\"did_HoldVehicle\":\"차량 보류\",\"did_ImportTaught\":\"티칭 값 가져오기\",\"did_JogDrive\":\"드라이브 조그\",\"did_JogEnd\":\"조그 종료\",\"did_LiftDeviceLockout\":\"장치 정비 잠금 해제\",\"did_LockDrive\":\"드라이브 정비 잠금\",\"did_LockOutDevice\":\"장치 정비 잠금\",\"did_LockVehicle\":\"차량 정비 잠금\",\"did_MoveVehicle\":\"차량 이동\",\"did_OpenPlace\":\"폐쇄 해제\",\"did_OpenTeaching\":\"티칭 세션 열기\",\"did_ParkVehicle\":\"차량 주차\",\"did_PauseController\":\"전체 일시정지\",\"did_PauseZone\":\"구역 일시정지\",\"did_PinDoor\":\"도어 상태 유지\",\"did_PressDriveKey\":\"드라이브 키 입력\",\"did_RaiseEmergency\":\"비상 상황 알림\",\"did_ReadDrive\":\"드라이브 파라미터 읽기\",\"did_RecoverAlarm\":\"알람 복구\",\"did_RejectProposal\":\"티칭 반려\",\"did_ReleaseEmergency\":\"비상 상황 해제\",\"did_ReleaseVehicle\":\"차량 보류 해제\",\"did_RemoveWebhook\":\"웹훅 삭제\",\"did_RenewWebhookSecret\":\"웹훅 비밀 값 갱신\",\"did_ReplayWebhook\":\"이벤트 다시 전달\",\"did_RestoreDrive\":\"드라이브 복원\",\"did_ResumeController\":\"전체 재개\",\"did_ResumeZone\":\"구역 재개\",\"did_RollBackDest\":\"DEST 되돌리기\",\"did_RollBackOffset\":\"OFFSET 되돌리기\",\"did_SetDeviceService\":\"장치 사용 여부 변경\",\"did_SetDriveInputs\":\"드라이브 입력 설정\",\"did_SetService\":\"차량 사용 여부 변경\",\"did_StageVehicle\":\"차량 미리 보내기\",\"did_StartTeaching\":\"티칭 시작\",\"did_StartWalk\":\"재고 실사 시작\",\"did_StopAll\":\"전체 정지\",\"did_StopDriveLine\":\"회선 드라이브 정지\",\"did_UnlockDrive\":\"드라이브 정비 잠금 해제\",\"did_UnlockVehicle\":\"차량 정비 잠금 해제\",\"did_UnpinDoor\":\"도어 제어 반환\",\"did_WriteCarrier\":\"캐리어 기록\",\"did_WriteDest\":\"DEST 입력\",\"did_WriteDrive\":\"드라이브 파라미터 쓰기\",\"did_WriteOffset\":\"OFFSET 입력\",\"did_WriteStation\":\"스테이션 기록\",\"did_BeginLayout\":\"첫 플랜트 파일\",\"did_LogIn\":\"로그인\",\"did_LogOut\":\"로그아웃\",\"did_ChangePassword\":\"암호 변경\",\"did_AddUser\":\"사용자 추가\",\"did_ChangeUser\":\"사용자 변경\",\"did_AddKey\":\"키 발급\",\"did_RevokeKey\":\"키 폐기\",\"did_Forbidden\":\"역할로 허용되지 않음\",\"expired\":\"만료됨\",\"opened\":\"해제됨\",\"not_known_yet\":\"아직 알 수 없습니다: 제어기가 응답하지 않았습니다.\",\"not_known_since\":\"{0}부터 알 수 없습니다: 제어기가 응답하지 않습니다.\",\"not_known_then\":\"그 시점에 대해 아직 알 수 없습니다.\",\"no_such\":\"그런 이름은 없습니다.\",\"away_never\":\"제어기가 아직 응답하지 않았습니다. 비어 있는 것은 없는 것이 아니라 모르는 것입니다.\",\"away_since\":\"제어기가 {0}부터 응답하지 않습니다({1}). 표시된 것은 모두 그때의 상태입니다.\",\"state_then\":\"{1} 당시 {0}\",\"past_away\":\"재생 · 제어기 응답 없음\",\"link_lost\":\"응답 없음\",\"and_more\":\"외 {0}개\",\"each_by_itself\":\"하나씩 보기\",\"acknowledge_all\":\"{0}건 모두 확인\",\"release_all\":\"{0}대 해제: 보고가 맞음\",\"all_acknowledged\":\"모두 확인됨\",\"note_or_reason\":\"메모 또는 해제 사유\",\"done_of\":\"{1}건 중 {0}건 처리\",\"no_alarms_but\":\"알람은 아니지만 보류되었거나 응답 없음: {0}\",\"no_alarms_but_title\":\"사람이 보류·잠금했거나 10초 미만 응답이 없는 것으로, 알람 수에 넣지 않습니다.\",\"alarm_count_title\":\"현재 알람 수(기계·코드마다 하나); 미확인 {0}\",\"look_count_title\":\"지도에서 '{0}' 상태인 차량 수\",\"closures_by_people\":\"사람이 폐쇄한 곳\",\"closures_title\":\"사람이 폐쇄하고 아직 열지 않은 것. 다른 이유로 경로가 피하는 곳은 아래에 있습니다.\",\"kept_off_title\":\"경로가 피하는 이유(사람의 폐쇄 포함): {0}가지, 선로의 {1}곳\",\"cut_off_title\":\"그 때문에 아무도 갈 수 없는 스테이션. 그곳의 작업은 대기합니다.\",\"against_lockout\":\"{0} 님이 잠금: {1}. 먼저 잠금을 해제하세요.\",\"against_emergency\":\"화재나 지진 통보 중에는 아무것도 움직이지 않습니다. 먼저 비상을 해제하세요(플랜트…).\",\"against_work\":\"작업 중인 구간에 서 있습니다: {0}, {1} 님이 폐쇄. 먼저 여세요.\",\"against_link\":\"연결되어 있지 않습니다. 회선과 전원을 확인하세요.\",\"against_recovery\":\"알람 복구가 진행 중입니다. 끝날 때까지 기다리세요.\",\"against_not_mant\":\"현재 {0}이며 MANT가 필요합니다. 먼저 '정지 (MANT)'를 누르세요.\",\"against_mant\":\"현재 MANT이며 AUTO나 SEMI가 필요합니다.\",\"against_off_rail\":\"레일에서 제거된 상태입니다. 먼저 해제하세요.\",\"against_hold\":\"보류 상태입니다. 먼저 해제하세요.\",\"against_service\":\"사용 제외 상태입니다. 먼저 사용으로 되돌리세요.\",\"against_job\":\"작업 {0} 수행 중입니다. 작업을 취소하거나 끝날 때까지 기다리세요.\",\"against_not_auto\":\"AUTO가 아닙니다. 복구하거나 서보 켜기, 원점 탐색, 자동을 누르세요.\",\"against_alarm\":\"알람 상태입니다. 먼저 복구하세요.\",\"against_settling\":\"위치를 확인하는 중입니다. 잠시 뒤 다시 하세요.\",\"against_roll_call\":\"아직 확인되지 않은 차량: {0}. 연결하거나 해제하세요.\",\"against_elsewhere\":\"스테이션(바코드 {0})이 아니라 {1}에 있습니다. 먼저 그곳으로 이동하세요.\",\"against_loaded\":\"이미 싣고 있어 하역만 할 수 있습니다.\",\"against_empty\":\"비어 있어 적재만 할 수 있습니다.\",\"against_runs\":\"정지 상태가 아닙니다. 정지하거나 기다리세요.\",\"against_agv_manual\":\"자동 모드가 아닙니다. 모드는 AGV에서만 바꿀 수 있습니다.\",\"against_agv_auto\":\"수동 모드가 아닙니다. 모드는 AGV에서만 바꿀 수 있습니다.\",\"against_no_error\":\"리셋할 오류가 없습니다.\",\"against_stands\":\"정지해 있습니다. 주행 중인 AGV에만 쓸 수 있습니다.\",\"against_no_charger\":\"충전기 위치가 아닙니다. 먼저 충전기로 이동하세요.\",\"against_linked\":\"연결되어 위치를 직접 보고합니다. 먼저 전원을 끄세요.\",\"against_nothing_held\":\"보류 상태가 아니므로 해제할 것이 없습니다.\",\"against_unknown\":\"아직 알려진 것이 없습니다.\",\"against_silent\":\"응답이 없습니다. 회선과 전원을 확인하세요.\",\"against_locked_for\":\"{0}을(를) 위해 잠겨 있습니다. 끝날 때까지 기다리세요.\",\"against_pin\":\"{0} 님이 문을 고정했습니다. 먼저 고정을 해제하세요.\",\"against_engaged\":\"닫을 수 없습니다: {0}이(가) 통과 중입니다.\",\"against_line\":\"회선 {0}이(가) 연결되어 있지 않습니다. 회선 탭을 보세요.\",\"against_offline\":\"응답이 없습니다. 전원, 케이블, ID를 확인하세요.\",\"against_operation\":\"작동 {0}이(가) 진행 중입니다. 기다리거나 취소하세요.\",\"against_drive_runs\":\"축이 움직이고 있습니다. 먼저 정지하세요.\",\"against_drive_error\":\"오류 상태입니다. 원인을 확인하고 정지/리셋을 누르세요.\",\"against_not_jog\":\"조그 모드가 아닙니다. 드라이브 패널에서 조그로 바꾸세요.\",\"against_other_vehicle\":\"캐리어가 {0}에 있거나 싣는 중이라 다른 차량에 줄 수 없습니다.\",\"the_room\":\"이 페이지의 ‘{0}’\",\"legend_unknown\":\"무엇이 있는지 모르거나 의심됨\",\"no_room\":\"이 페이지에 {0} 화면이 없어 지도를 표시합니다.\",\"taken_back\":\"{0}에 회수됨\",\"had_before\":\"이전:\",\"field_key\":\"키\",\"field_any_vehicle\":\"아무 차량\",\"field_forgotten\":\"모름으로 되돌림\",\"field_by_person\":\"사람이 기록\",\"field_walked\":\"실사로 확인\",\"field_stop\":\"정지\",\"choose_version\":\"버전을 선택하면 달라지는 점과 깨지는 점이 보입니다.\",\"choose_proposal\":\"티칭하면 제안과 그로 인한 변경이 여기에 보입니다.\",\"nothing_in_period\":\"이 기간에는 자료가 없습니다.\",\"mttr_minutes\":\"MTTR (분)\",\"seconds_unit\":\"초\",\"mtbf_hours\":\"MTBF (시간)\",\"field_idempotency_key\":\"Idempotency-Key\",\"field_fallbacks\":\"대체 도착지\",\"field_text\":\"문구\",\"field_alarm\":\"알람\",\"field_pickup\":\"적재\",\"field_target\":\"목표 펄스\",\"field_confirmed\":\"사람이 확인함\",\"field_verdict\":\"판단\",\"field_pulses\":\"펄스\",\"field_expected\":\"예상 값\",\"field_raw\":\"원시값\",\"field_value\":\"값\",\"field_raw_access\":\"원시 접근\",\"field_other\":\"비교 드라이브\",\"field_model\":\"모델\",\"field_dry_run\":\"모의 실행\",\"field_turn\":\"방향\",\"field_operation\":\"작업 번호\",\"field_session\":\"세션\",\"field_abandon\":\"포기\",\"field_proposal\":\"제안\",\"field_accept\":\"그래도 승인\",\"field_to\":\"되돌릴 버전\",\"field_rows\":\"행\",\"field_expires\":\"자동 해제\",\"field_closure\":\"폐쇄\",\"field_walk\":\"재고 실사\",\"field_partial\":\"일부만\",\"field_url\":\"URL\",\"field_events\":\"이벤트\",\"field_after\":\"이후 이벤트\",\"field_webhook\":\"웹훅\",\"field_active\":\"사용\",\"field_overlap\":\"이전 비밀 유지 시간\"}");
var remedies = {
	"malformed": "UTF-8 JSON 본문을 보내세요.",
	"method": "경로와 메서드는 /api/docs에 있습니다.",
	"too-large": "한 번에 더 적게 보내세요.",
	"invalid": "고쳐서 다시 보내세요. /api/docs에 허용되는 값이 있습니다.",
	"other": "/api/docs를 보세요."
};
var sayings = /*#__PURE__*/ JSON.parse("{\"named_in_brackets\":\"{0} ({1})\",\"waits_at_for_held_by\":\"{1}의 {0}: {3} 점유 {2} 대기\",\"waits_at_for_door\":\"{1}의 {0}: 도어 {2} 대기\",\"waits_at_no_slot_is\":\"{1}의 {0}: {2}부터의 대기열에 빈자리 없음. 먼저 나갈 차량: {3}\",\"waits_at_no_slot_is_free\":\"{1}의 {0}: {2}부터의 대기열에 빈자리 없음\",\"closed_by_for\":\"{0} 님이 폐쇄: {1} ({2})\",\"closed_for_work_by\":\"{0} 님이 작업을 위해 폐쇄: {1} ({2})\",\"is_there_silent\":\"{0}이(가) 그곳에 있으나 응답 없음: {1}\",\"stands_before_an_obstacle\":\"{0}이(가) 장애물 앞에 서 있음\",\"stands_there_for\":\"{0}이(가) 서 있음, {1}\",\"nobody_of_that_name\":\"이름 또는 암호가 올바르지 않습니다.\",\"try_again\":\"다시 시도하십시오.\",\"no_key_or_session\":\"지금 유효한 키나 세션이 아닙니다.\",\"log_in_or_send\":\"로그인하거나 유효한 키를 사용하십시오.\",\"wants_to_know\":\"이 서버는 로그인이 필요합니다.\",\"too_many_attempts\":\"잘못된 시도가 너무 많습니다.\",\"try_again_in\":\"{0}초 후 다시 시도하십시오.\",\"not_the_old_password\":\"이전 암호가 아닙니다.\",\"administrator_can_give\":\"관리자가 새 암호를 줄 수 있습니다.\",\"logged_in_too_long_ago\":\"로그인한 지 너무 오래되었습니다.\",\"session_has_ended\":\"세션이 끝났습니다.\",\"log_in_again\":\"다시 로그인하십시오.\",\"looks_like_somebody\":\"{0}은(는) 감사 기록에서 다른 사람과 혼동됩니다.\",\"choose_another_name\":\"다른 이름을 고르십시오.\",\"is_last_administrator\":\"{0}은(는) 마지막 관리자입니다.\",\"password_must_not\":\"암호에 이름을 넣을 수 없고 서로 다른 문자가 다섯 개 이상이어야 합니다.\",\"row_has_been_changed\":\"{0}행이 변경되었거나 {1}행과 {2}행 사이에 행이 빠지거나 끼어들었습니다\",\"needs_the_role\":\"{0}에는 {1} 역할이 필요합니다. {2}의 역할: {3}.\",\"waits_at_zone_takes_in\":\"{1}의 {0}: 구역 {2} 지금은 추가 진입 불가\",\"waits_at_others_have_waited\":\"{1}의 {0}: {2}부터의 대기열을 더 오래 기다린 차량이 있음. 먼저 나갈 차량: {3}\",\"waits_at_others_have_waited_longer\":\"{1}의 {0}: {2}부터의 대기열을 더 오래 기다린 차량이 있음\",\"waits_at_the_last_slot\":\"{1}의 {0}: {2}부터의 대기열 마지막 자리는 순환 교착이 될 수 있음. 먼저 나갈 차량: {3}\",\"waits_at_the_last_slot_in\":\"{1}의 {0}: {2}부터의 대기열 마지막 자리는 순환 교착이 될 수 있음\",\"waits_at_is_closed\":\"{1}의 {0}: {2} 폐쇄됨 ({3})\",\"waits_at_the_roll_call\":\"{1}의 {0}: 점호에서 {2} 응답 대기\",\"waits_at\":\"{1}의 {0}: {2}\",\"which_excludes_track\":\"{0}(교차 트랙)\",\"in_zone\":\"구역 {1}의 {0}\",\"which_is_picking_up_at\":\"{1}에서 적재 중인 {0}({2}초)\",\"which_is_putting_down_at\":\"{1}에 내려놓는 중인 {0}({2}초)\",\"which_is_used_for_teaching\":\"티칭 중인 {0}(세션 {1})\",\"which_is_silent\":\"응답 없는 {0}({1})\",\"which_has_an_alarm\":\"알람 중인 {0}\",\"which_is_being_asked_where\":\"위치 확인 중인 {0}\",\"which_is_moving\":\"이동 중인 {0}\",\"used_for_teaching\":\"티칭 중 (세션 {0})\",\"which_waits_itself\":\"자신도 대기 중인 {0}\",\"which_is_idle_there\":\"그곳에서 유휴 중인 {0}\",\"which_is\":\"{0}({1})\",\"wait_for_each_other_in\":\"{0} 순환 대기 ({1}). 다른 길을 찾지 못하면 {2}을(를) 수동으로 옮기거나 레일에서 내리세요\",\"fire_told_by\":\"화재, 통보자 {0}\",\"earthquake_told_by\":\"지진, 통보자 {0}\",\"controller_is_paused\":\"제어기 일시정지\",\"controller_is_pausing\":\"제어기 일시정지 중\",\"the_controller_is\":\"제어기 상태: {0}\",\"everything_is_stopped_by\":\"{0} 님이 전체 정지\",\"the_roll_call_still_misses\":\"점호에서 {0} 응답 대기\",\"no_vehicle_is_free_is\":\"가용 차량 없음: {0} 작업 {1} 수행 중, {2}\",\"no_vehicle_is_free_and\":\"가용 차량 없음: {0} {1}, {2}\",\"no_vehicle_is_free\":\"가용 차량 없음\",\"no_vehicle_can_serve_both\":\"두 스테이션을 모두 처리할 차량이 없음. DEST, OFFSET, 한계를 확인하세요\",\"cannot_serve_both_stations\":\"두 스테이션을 모두 처리할 수 없음\",\"cannot_serve\":\"{0} 처리 불가: {1}\",\"is_not_connected\":\"연결되지 않음\",\"is_not_ready\":\"준비되지 않음\",\"it_is_not_ready\":\"준비되지 않음\",\"is_not_free\":\"가용 상태가 아님\",\"is_on_job\":\"작업 {0} 수행 중\",\"is_on_job_for_s\":\"작업 {0} 수행 중, {1}초 남음\",\"would_have_had_to_be\":\"변경 이득이 너무 적음\",\"has_the_carrier_aboard\":\"캐리어를 싣고 있음\",\"is_asked_for\":\"지정됨\",\"is_used_for_teaching_session\":\"티칭에 사용 중(세션 {0})\",\"it_waits_for_which_will\":\"가까운 곳에서 곧 비는 {0} 대기\",\"brings_a_carrier_to_first\":\"{0}이(가) 먼저 {1}에 캐리어를 가져옴\",\"other_jobs_to_come_first\":\"{0}행 다른 작업이 먼저임\",\"another_job_is_being_fetched\":\"{0}에서 다른 작업을 인수하는 중\",\"is_the_destination_of_already\":\"{0}은(는) 이미 {1}의 목적지임\",\"the_track_carries_no_more\":\"지금은 트랙 여유 없음: 작업 차량은 {0}대까지\",\"is_empty_its_buffer_reports\":\"{0} 비어 있음: 버퍼가 카트 없음으로 보고\",\"is_empty\":\"{0} 비어 있음\",\"is_empty_is_at\":\"{0} 비어 있음: {1}은(는) {2}에 있음\",\"cancelled_by_because\":\"{0} 님이 취소: {1}\",\"aborted_by\":\"{0} 님이 중단\",\"aborted_by_because\":\"{0} 님이 중단: {1}\",\"fall_back_is_the_destination\":\"대체지 {0}은(는) 도착지임\",\"fall_back_is_named_twice\":\"대체지 {0}이(가) 두 번 지정됨\",\"name_other_stations_or_leave\":\"다른 스테이션을 지정하거나 생략하세요\",\"cannot_be_where_nobody_knows\":\"무엇이 있는지 알 수 없는 곳에 {0}이(가) 있을 수 없음\",\"send_present_true_with_it\":\"present를 true로 함께 보내거나 carrier를 생략하세요\",\"holds_not\":\"{0}에는 {2}이(가) 아니라 {1}이(가) 있음\",\"is_at_not_at\":\"{0}은(는) {2}이(가) 아니라 {1}에 있음\",\"is_out_of_service\":\"{0} 사용 중지: {1}\",\"goes_with_version\":\"{0}: 곧 적용될 플랜트 버전 {1}에 없습니다\",\"cut_off_by_version\":\"{0}: 곧 적용될 플랜트 버전 {1}에서는 갈 수 없습니다\",\"is_reserved\":\"{0} 예약됨: {1}\",\"is_occupied_its_buffer_reports\":\"{0} 점유됨: 버퍼가 카트 있음으로 보고\",\"is_occupied_by\":\"{0}에 {1}이(가) 있음\",\"is_closed\":\"{0} 폐쇄됨 ({1})\",\"is_being_taught_by_with\":\"{1} 님이 {2}(으)로 {0} 티칭 중 (세션 {3})\",\"nothing_is_aboard\":\"{0}에 캐리어 없음\",\"carries_not\":\"{0}에는 {2}이(가) 아니라 {1}이(가) 실려 있음\",\"its_destination_cannot_be_used\":\"목적지를 사용할 수 없음\",\"finds_no_way\":\"{0} 경로 없음: {1}\",\"no_route_from_to_is\":\"{0}에서 {1}(으)로 가는 경로 없음: {2} 폐쇄됨\",\"held_by\":\"{0} 님이 보류: {1}\",\"on_hold\":\"보류: {0}\",\"off_the_rail\":\"레일 밖: {0}\",\"out_of_service\":\"사용 중지: {0}\",\"locked_out_by\":\"{0} 님 정비 잠금: {1}\",\"locked_out\":\"정비 잠금: {0}\",\"stopped_by\":\"{0} 님이 정지\",\"release_it_when_it_may\":\"계속해도 되면 해제하세요\",\"it_is_not_connected\":\"연결되지 않음: {0}\",\"not_connected_yet\":\"아직 연결되지 않음\",\"the_link_was_lost\":\"링크가 끊어짐\",\"it_drives_where_it_may\":\"허가되지 않은 곳을 주행함\",\"is_in_alarm\":\"알람 {0}\",\"has_an_alarm\":\"{0} 알람 중\",\"has_its_servos_off_send\":\"서보 꺼짐: SERVO ON, SEARCH HOME, AUTO를 보내세요\",\"has_not_found_its_home\":\"원점을 찾지 못함: SEARCH HOME을 보내세요\",\"has_an_axis_that_is\":\"원점에 있지 않은 축이 있음\",\"reads_no_barcode_bring_it\":\"바코드를 읽지 못함: 수동으로 바코드 위치로 옮기세요\",\"reports_barcode_which_is_not\":\"지도에 없는 바코드 {0} 보고 (프로토콜 변형 확인)\",\"it_reports_barcode_at_seq\":\"SEQ {1}에서 바코드 {0} 보고, 경로에는 {2}\",\"it_reports_barcode_which_cannot\":\"점유 트랙({1})에서 갈 수 없는 바코드 {0} 보고\",\"reports_barcode_which_is_not_on\":\"{0}이(가) 점유하지 않은 트랙의 바코드 {1} 보고\",\"reports_from_on_track_that\":\"{0}이(가) {2}에 허가된 트랙({3})의 {1}에서 보고\",\"it_carries_a_that_no\":\"작업·기록에 없는 {0}을(를) 싣고 있음\",\"it_should_carry_and_its\":\"{0}을(를) 싣고 있어야 하나 {1} 비트가 0\",\"its_place_ended_in_and\":\"PLACE가 {0}(으)로 끝났고 {1} 비트가 0\",\"clear_the_cause_then_post\":\"원인을 없앤 뒤 알람 복구를 누르세요 ({0})\",\"see_what_is_wrong_then\":\"원인을 확인한 뒤 알람 복구를 누르세요 ({0})\",\"mend_the_cause_then_post\":\"원인을 고친 뒤 다시 알람 복구를 누르세요 ({0})\",\"post_api_v_vehicles_recover\":\"연결되면 다시 알람 복구를 누르세요 ({0})\",\"not_homed_because_let_a\":\"원점 복귀 안 함: {0}. 사람이 확인해야 합니다\",\"nothing_came_of_it_for\":\"{0}초 동안 반응 없음\",\"look_where_it_stands_then\":\"위치를 확인한 뒤 '보고가 맞음'으로 해제하세요\",\"look_where_it_stands_bring\":\"위치를 확인하고 읽히는 바코드로 옮긴 뒤 '보고가 맞음'으로 해제하세요\",\"look_where_it_stands_release\":\"위치를 확인하고 바코드가 맞으면 '보고가 맞음'으로 해제하세요\",\"release_it_with_verdict_go\":\"다시 레일에 있으면 '보고가 맞음'으로 해제하세요\",\"look_at_the_vehicle_and\":\"차량과 진행 경로를 확인한 뒤 해제하세요\",\"see_that_its_way_is\":\"진행 경로가 비었는지 확인한 뒤 해제하세요\",\"see_that_the_carrier_stands\":\"캐리어 위치를 확인한 뒤 '보고가 맞음'으로 해제하세요\",\"see_what_it_carries_put\":\"실린 캐리어를 확인해 기록한 뒤 '보고가 맞음'으로 해제하세요\",\"find_the_carrier_correct_its\":\"캐리어를 찾아 위치를 고친 뒤 '보고가 맞음'으로 해제하세요 (작업은 실패 처리됨)\",\"look_whether_the_carrier_is\":\"캐리어가 차량에 있는지 스테이션에 있는지 확인해 고친 뒤 해제하세요\",\"look_at_the_vehicle_and_the\":\"차량과 스테이션을 확인하고 필요하면 목적지를 바꾼 뒤 해제하세요\",\"ended_abnormally_times\":\"{0}회 비정상 종료 ({1})\",\"ended_abnormally\":\"{0} 비정상 종료 ({1})\",\"no_reason_given\":\"사유 없음\",\"pickup_refused_by_the_vehicle\":\"차량이 PICKUP을 거부함\",\"place_at_was_refused_times\":\"{0}에서 PLACE가 {1}회 거부됨\",\"the_carrier_is_aboard_order\":\"캐리어가 차량에 있음: 차량에서 출발하는 작업을 등록하세요\",\"aborted_the_carrier_is_aboard\":\"중단됨. 캐리어가 차량에 있음: 차량에서 출발하는 작업을 등록하세요\",\"aborted_nothing_is_aboard\":\"중단됨. 실린 캐리어 없음\",\"the_carrier_is_no_longer\":\"캐리어가 더 이상 차량에 없음\",\"is_silent\":\"응답 없음: {0}\",\"is_silent_2\":\"{0} 응답 없음: {1}\",\"see_its_line_and_its\":\"회선과 전원을 확인하세요\",\"look_at_its_line_and\":\"회선과 전원을 확인하세요\",\"reports_an_error\":\"오류(255)를 보고함\",\"does_not_know_its_state\":\"자신의 상태를 모름(3)\",\"look_at_the_device_then\":\"장치를 확인한 뒤 다시 명령하세요\",\"is_not_open_and_cannot\":\"열려 있지 않고 {0}을(를) 그 앞에서 멈출 수 없음\",\"look_at_and\":\"{0}과(와) {1}을(를) 확인하세요\",\"reports_no_cart_but_is\":\"카트 없음 보고, 기록에는 {1}에 {0}이(가) 있음\",\"look_there_then_put_api\":\"현장을 확인해 스테이션 상태를 기록하세요\",\"the_line_is_down\":\"회선 끊김: {0}\",\"is_locked_for\":\"{0}: {1}용으로 잠김\",\"is_locked_out_by\":\"{0}: {1} 님 정비 잠금\",\"is_locked_out_by_already\":\"{0}: 이미 {1} 님이 정비 잠금\",\"the_lockout_is_s_your\":\"{0} 님의 정비 잠금입니다. 해제 요청을 기록했습니다\",\"alone_can_lift_it_or\":\"{0} 님만 해제할 수 있거나, 다른 한 사람이 더 요청해야 합니다\",\"lift_the_lockout_first\":\"먼저 정비 잠금을 해제하세요\",\"is_s_for_people_at\":\"{1} 님의 작업자 폐쇄({0})입니다. 해제 요청을 기록했습니다\",\"alone_can_open_it_or\":\"{0} 님만 해제할 수 있거나, 다른 한 사람이 더 요청해야 합니다\",\"a_closure_for_people_s\":\"작업자 폐쇄는 저절로 끝나지 않습니다\",\"there_is_no_station\":\"스테이션 {0} 없음\",\"there_is_no_vehicle\":\"차량 {0} 없음\",\"there_is_no_barcode\":\"바코드 {0} 없음\",\"there_is_no_station_or\":\"스테이션 또는 차량 {0} 없음\",\"source_and_destination_are_the\":\"출발지와 도착지가 같습니다\",\"no_vehicle_serves_both_and\":\"{0}과(와) {1}을(를) 모두 처리하는 차량이 없습니다\",\"order_two_jobs_and_let\":\"작업을 둘로 나누어 등록하세요\",\"the_carrier_is_aboard\":\"캐리어가 {0}에 실려 있음\",\"the_carrier_is_aboard_or\":\"캐리어가 {0}에 실려 있거나 적재 중\",\"job_is_the_carrier_is\":\"작업 {0}: {1}. 캐리어가 실려 있거나 적재 중\",\"job_is_nothing_was_picked\":\"작업 {0}: {1}. 아직 적재하지 않음\",\"job_has_ended\":\"작업 {0} 종료됨: {1}\",\"order_a_new_job\":\"새 작업을 등록하세요\",\"is_not_connected_2\":\"{0} 연결되지 않음: {1}\",\"is_not_in_auto\":\"{0} AUTO가 아님\",\"is_handling_a_carrier\":\"{0} 캐리어 적재·하역 중\",\"wait_for_its_end\":\"끝날 때까지 기다리세요\",\"is_on_job_2\":\"{0} 작업 {1} 수행 중\",\"cancel_the_job_or_let\":\"작업을 취소하거나 끝날 때까지 기다리세요\",\"is_in_and_needs_mant\":\"{0}이(가) {1} 상태이고 {2}에는 MANT가 필요함\",\"send_stop_first_it_brings\":\"먼저 정지를 보내세요. MANT로 바뀝니다\",\"nothing_needs_to_be_done\":\"할 일이 없습니다\",\"is_in_auto_homed_and\":\"{0}: AUTO, 원점 완료, 알람 없음\",\"homing_now_could_drop_a\":\"지금 {0} 원점 복귀는 캐리어를 떨어뜨릴 수 있음: {1}\",\"let_a_person_look_at\":\"사람이 차량을 확인한 뒤 확인란을 선택하세요\",\"still_has_an_alarm\":\"{0} 아직 알람 중\",\"nothing_moves\":\"아무것도 움직이지 않음: {0}\",\"release_the_emergency_first\":\"먼저 비상 상황을 해제하세요\",\"resume_it_first\":\"먼저 재개하세요\",\"has_no_dest\":\"{0}에 DEST 없음 ({1})\",\"has_no_offset\":\"{0}에 OFFSET 없음 ({1})\",\"teach_it_post_api_v\":\"티칭하거나 {0}의 DEST를 입력하세요\",\"teach_it_post_api_v_teaching\":\"티칭하거나 {0}의 OFFSET을 입력하세요\",\"look_at_its_changes_then\":\"변경 내용을 보고 승인하거나 반려하세요\",\"teach_again_or_reject_it\":\"다시 티칭하거나 반려하세요\",\"came_more_may_follow\":\"{0} 수신, 더 올 수 있음\",\"wait_some_seconds\":\"몇 초 기다리세요\",\"far_from_version\":\"버전 {0}과(와) 차이 큼: {1}\",\"bring_to_barcode_send_it\":\"{0}을(를) 바코드 {1}(으)로 이동시키세요 (정지 유형: 포트)\",\"send_the_command_stop_it\":\"{0}에 정지를 보내세요. MANT로 바뀝니다\",\"align_the_hoist_over_the\":\"호이스트를 포트 위에 맞춘 뒤 DEST 또는 OFFSET 티칭을 누르거나, 차량에서 축별로 보내세요\",\"proposal_is\":\"제안 {0}: {1}. {2}\",\"nothing_the_session_is_over\":\"할 일 없음: 세션이 끝났습니다\",\"a_named_person_has_to\":\"이름을 밝힌 사람이 결정해야 합니다.\",\"send_the_header_x_actor\":\"오른쪽 위에 이름을 적으세요.\",\"the_server_does_not_answer\":\"서버가 응답하지 않습니다.\",\"there_is_no\":\"{0} {1} 없음.\",\"is_being_locked_for\":\"{0}: {1}용으로 잠그는 중\",\"to_the_source\":\"출발지까지: {0}\",\"is_farther\":\"더 멂\",\"does_job\":\"{0} 수행 중\",\"keeps_job\":\"{0} 유지\",\"status_shows_it\":\"상태 보고로 확인\",\"by_the_place_where_the_vehicle\":\"차량이 선 위치로 판정\",\"first_start_on_this_database\":\"이 데이터베이스의 첫 시작\",\"accepted_by_it\":\"수락됨\",\"and_f_agrees\":\"RESULT {0}, FOUP 비트 일치\",\"cannot_go_on\":\"{0} 진행 불가: {1}\",\"it_is_due_to_charge\":\"충전할 때가 됨\",\"plant_file_itself\":\"플랜트 파일\",\"stretch_is_closed\":\"{0}~{1} 폐쇄됨({2})\",\"stretch_is_closed_by\":\"{0}~{1} {2} 님이 폐쇄: {3} ({4})\",\"is_closed_by\":\"{0} {1} 님이 폐쇄: {2} ({3})\",\"cannot_be_reached\":\"{0} 도달 불가: {1}\",\"ways_lead_round\":\"{0} 우회\",\"closure_number\":\"폐쇄 {0}\",\"may_stand_at_where_a_pick\":\"{1}에서 집기(PICKUP)가 실패하여 {0}이(가) 남아 있을 수 있습니다: 확인한 뒤 PATCH /api/v1/stations/{2}에 present를 보내세요\",\"not_known_a_pick_up_failed\":\"알 수 없음: 그곳에서 집기(PICKUP)가 실패했습니다\",\"nobody_knows_where_it_is\":\"위치를 알 수 없음: {0}\",\"took_from_instead\":\"{0}이(가) {2}에서 대신 {1}을(를) 집었습니다\",\"put_down_at\":\"{0}이(가) {2}에 {1}을(를) 내려놓았습니다\",\"can_be_reached_again\":\"{0} 다시 도달 가능\",\"they_can_be_reached_again\":\"다시 도달 가능\",\"move_away_what_stands\":\"그곳에 서 있는 것을 치우거나 폐쇄를 해제하십시오. 그곳으로 가는 작업은 대기하다가 해제되면 계속됩니다\",\"stretch_has_expired\":\"{0}~{1} 폐쇄 만료({2})\",\"has_expired\":\"{0} 폐쇄 만료({1})\",\"stretch_is_opened_by\":\"{0}~{1} {2} 님이 해제({3})\",\"is_opened_by\":\"{0} {1} 님이 해제({2})\",\"no_way_leads\":\"{0}에서 {1}(으)로 가는 길 없음: {2}\",\"the_mode_is_changed_at\":\"모드는 AGV에서만 바꿀 수 있음 (ENIG에 해당 명령 없음)\",\"is_an_agv_is_a\":\"{0}은(는) AGV: {1}은(는) 호이스트 명령\",\"agvs_take_stop_alarm_clear\":\"AGV에는 stop, alarm_clear, agv_ 명령을 보내세요. {0}\",\"reports_no_error_to_reset\":\"{0}: 리셋할 오류 없음\",\"leave_it_as_it_is\":\"그대로 두세요\",\"is_an_agv_and_has\":\"{0}은(는) AGV라 표시 장치 없음: {1} 표시 안 됨\",\"send_display_to_a_hoist\":\"display는 호이스트에 보내세요\",\"is_an_agv_it_has\":\"{0}은(는) AGV: 정지 유형 {1} 없음\",\"leave_action_out_or_send\":\"action을 빼거나 stop을 보내세요\",\"is_a_hoist_agv_commands\":\"{0}은(는) 호이스트: agv_ 명령은 AGV 전용\",\"send_it_a_hoist_s\":\"호이스트 명령을 보내세요\",\"stands\":\"{0} 서 있음\",\"send_it_to_an_agv\":\"주행 중인 AGV에 보내세요\",\"an_agv_is_sent_to\":\"AGV는 move로 태그에 보냄\",\"send_move_with_the_barcode\":\"바코드를 지정해 move를 보내세요\",\"is_no_agv_s_command\":\"{0}은(는) AGV 명령이 아님\",\"send_stop_or_alarm_clear\":\"stop 또는 alarm_clear를 보내세요\",\"is_in\":\"{0}: {1} 상태\",\"switch_it_to_at_the\":\"AGV에서 {0}(으)로 바꾸세요: {1}\",\"is_in_error\":\"{0} 오류 상태\",\"does_not_stand_still\":\"{0} 정지 상태 아님\",\"stop_it_or_wait\":\"정지시키거나 기다리세요\",\"there_is_no_tag_on\":\"AGV 주행면에 태그 {0} 없음\",\"see_get\":\"GET {0}에서 확인하세요\",\"lift_that_first\":\"먼저 그것을 해제하세요\",\"stands_at_no_charger_told\":\"{0}이(가) 충전기에 있지 않음: 충전을 지시하면 스스로 고른 경로로 충전기까지 주행함\",\"send_move_to_one_of\":\"먼저 {0} 중 한 곳으로 move를 보내세요\",\"it_is_not_known_where\":\"{0}의 위치를 모름\",\"wait_until_it_has_reported\":\"보고할 때까지 기다리세요\",\"moveauto_follows_the_tape_until\":\"MoveAuto는 정지시킬 때까지 테이프를 따라가며, {0}이(가) 같은 주행면에 있을 수 있음\",\"send_move_to_a_tag\":\"태그로 move를 보내거나, 다른 차량을 주행면에서 내리세요 (verdict off_rail)\",\"lets_it_follow_the_tape\":\"{0} 님이 테이프를 따라가게 함\",\"stop_it_then_release_it\":\"정지시킨 뒤 선 자리에서 '보고가 맞음'으로 해제하세요\",\"there_is_no_alias\":\"별칭 {0} 없음\",\"known_are\":\"사용 가능: {0}\",\"may_choose_another_way_to\":\"{0}이(가) 허가될 경로와 다른 길로 {1}에 갈 수 있음\",\"send_move_to_it_leads\":\"{0}(으)로 move를 보내세요: 태그를 하나씩 거쳐 감\",\"the_way_to_is_not\":\"{0}까지의 경로가 비어 있지 않음: {1}\",\"wait_or_send_move_to\":\"기다리거나 {0}(으)로 move를 보내세요: 갈 수 있는 데까지 감\",\"it_is_not_known_what\":\"{0} 결과를 알 수 없음: {1}\",\"no_acknowledgement_after_four_transmissi\":\"네 번 전송했으나 확인 응답 없음\",\"acknowledged_but_no_answer_in\":\"확인 응답은 왔으나 제시간에 결과 응답 없음\",\"another_one_has_begun\":\"다른 알람으로 바뀜\",\"there_is_no_alarm\":\"알람 {0} 없음\",\"find_out_who_that_is\":\"누구인지 확인하세요: 주소나 DEV_ID가 잘못된 차량, 다른 제어기의 차량, 또는 침입자\",\"a_connection_is_refused_again\":\"연결 거부 반복: {0}\",\"the_controller_was_started_again\":\"제어기가 다시 시작됨\",\"it_is_not_in_the\":\"더 이상 플랜트에 없음\",\"it_is_connected_again\":\"다시 연결됨\",\"not_connected\":\"연결되지 않음: {0}\",\"nobody_has_been_refused_for\":\"한동안 거부된 연결 없음\",\"alarm\":\"알람 {0}\",\"alarm_2\":\"알람 {0}: {1}\",\"recovery_stopped\":\"복구 중단\",\"not_homed_because_let_a_2\":\"원점 복귀 안 함: {0}. 사람이 확인해야 합니다; {1}\",\"stopped_by_2\":\"{0} 님이 정지; {1}\",\"recovered_by\":\"{0} 님이 복구\",\"alarm_recovered\":\"{0} 님: 알람 복구됨\",\"no_name_under_alarm_codes\":\"{0}(alarm_codes에 이름 없음)\",\"no_port_of_the_plant\":\"바코드 {0}에 플랜트의 포트 없음\",\"bring_the_vehicle_to_a\":\"차량을 포트의 바코드로 옮겨 다시 티칭하거나, 플랜트 파일에 포트를 적고 다시 시작하세요\",\"share_barcode_and_no_teaching\":\"{0}이(가) 바코드 {1}을(를) 함께 쓰며, 티칭 세션이 지정한 포트 없음\",\"post_api_v1_teaching_proposals\":\"스테이션을 지정하세요 (POST /api/v1/teaching/proposals/{0}/assign)\",\"is_a_reference_vehicle_its\":\"{0}은(는) 기준 차량: OFFSET은 선언에 따라 0\",\"reject_it_or_take_reference\":\"반려하거나, 플랜트 파일에서 `reference`를 빼세요\",\"sent_it_in_and_teaching\":\"{0}이(가) {1}에서 보냄. 티칭에는 MANT가 필요함\",\"did_not_come\":\"{0} 수신 안 됨: {1}\",\"has_no_offset_so_no\":\"{0}에 OFFSET 없음 ({1}): 보낸 값에서 DEST를 구할 수 없음\",\"teach_at_a_reference_port\":\"기준 포트에서 {0}을(를) 티칭하거나 OFFSET을 입력하세요 (PUT /api/v1/vehicles/{1}/offset)\",\"has_no_dest_so_no\":\"{0}에 DEST 없음 ({1}): {2}이(가) 그곳에서 보낸 값에서 OFFSET을 구할 수 없음\",\"teach_with_a_vehicle_of\":\"OFFSET을 아는 차량으로 {0}을(를) 티칭하거나 DEST를 입력하세요 (PUT /api/v1/stations/{1}/dest)\",\"is_not_in_the_plant\":\"{0}: 더 이상 플랜트에 없음\",\"shft_is_outside\":\"SHFT {0}: 범위 {1} 밖\",\"rota_is_outside\":\"ROTA {0}: 범위 {1} 밖\",\"lift_is_outside\":\"LIFT {0}: 범위 {1} 밖\",\"shft_is_outside_of\":\"SHFT {0}: {2}의 범위 {1} 밖\",\"rota_is_outside_of\":\"ROTA {0}: {2}의 범위 {1} 밖\",\"lift_is_outside_of\":\"LIFT {0}: {2}의 범위 {1} 밖\",\"shft_for_is_outside_of\":\"{1}의 SHFT {0}: {3}의 범위 {2} 밖\",\"rota_for_is_outside_of\":\"{1}의 ROTA {0}: {3}의 범위 {2} 밖\",\"lift_for_is_outside_of\":\"{1}의 LIFT {0}: {3}의 범위 {2} 밖\",\"or_correct_the_vehicle_s\":\"또는 플랜트 파일에서 차량의 한계를 고치세요\",\"or_approve_with_accept\":\"또는 {\\\"accept\\\": [\\\"{0}\\\"]}(으)로 승인하세요\",\"what_follows_from_it_does\":\"계산 결과가 32비트에 들어가지 않음\",\"are_still_not_known_afterwards\":\"{0}: 그 뒤에도 값을 모름. 작업은 계속 거절됨\",\"and_more_are_out_of\":\"그 외 {0}건도 범위 밖\",\"out_of_range_for\":\"{0} 범위 초과: {1}\",\"out_of_range_at\":\"{0}에서 범위 초과: {1}\",\"by_the_plant_file\":\"플랜트 파일에 따름\",\"is_off_the_rail\":\"{0} 레일에서 내림\",\"is_off_the_rail_2\":\"{0} 레일 밖: {1}\",\"can_go_on\":\"{0} 계속 진행 가능\",\"in_alarm\":\"알람 {0}\",\"in_mant\":\"MANT 상태\",\"in_semi\":\"SEMI 상태\",\"not_ready\":\"준비되지 않음\",\"stands_there_on_hold\":\"{0}이(가) 서 있음, 보류: {1}\",\"is_there_silent_2\":\"{0}: {1}이(가) 그곳에 있으나 응답 없음: {2}\",\"stands_there_before_an_obstacle\":\"{0}: {1}이(가) 장애물 앞에 서 있음\",\"stands_there\":\"{0}: {1}이(가) 서 있음, {2}\",\"closed_by\":\"{0}: {1} 님이 폐쇄: {2} ({3})\",\"to_closed_by\":\"{0}~{1}: {2} 님이 폐쇄: {3} ({4})\",\"closed_for_people_at_work\":\"{0}: {1} 님이 작업을 위해 폐쇄: {2} ({3})\",\"to_closed_for_people_at\":\"{0}~{1}: {2} 님이 작업을 위해 폐쇄: {3} ({4})\",\"is_closed_2\":\"{0}: {1} 폐쇄됨 ({2})\",\"is_closed_stands_there\":\"{0}: {1} 폐쇄됨 ({2}이(가) 서 있음, {3})\",\"is_closed_is_there_silent\":\"{0}: {1} 폐쇄됨 ({2}이(가) 그곳에 있으나 응답 없음: {3})\",\"to_is_closed\":\"{0}: {1}~{2} 폐쇄됨 ({3})\",\"is_closed_for_people_at\":\"{0} {1} 님이 작업을 위해 폐쇄: {2} ({3})\",\"to_is_closed_for_people\":\"{0}~{1} {2} 님이 작업을 위해 폐쇄: {3} ({4})\",\"zone_is_closed_by\":\"구역 {0} {1} 님이 폐쇄: {2} ({3})\",\"zone_is_closed_for_people\":\"구역 {0} {1} 님이 작업을 위해 폐쇄: {2} ({3})\",\"zone_has_expired\":\"구역 {0} 폐쇄 만료({1})\",\"zone_is_opened_by\":\"구역 {0} {1} 님이 해제({2})\",\"zone_is_opened_by_2\":\"구역 {0} {1} 님이 해제: {2} ({3})\",\"is_opened_by_2\":\"{0} {1} 님이 해제: {2} ({3})\",\"to_is_opened_by\":\"{0}~{1} {2} 님이 해제: {3} ({4})\",\"no_way_leads_from_to\":\"{0}에서 {1}(으)로 가는 길 없음: {2} 폐쇄됨 ({3})\",\"no_way_leads_from_to_2\":\"{0}에서 {1}(으)로 가는 길 없음: {2}~{3} 폐쇄됨 ({4})\",\"no_route_from_to_is_2\":\"{0}에서 {1}(으)로 가는 경로 없음: {2} 폐쇄됨 ({3})\",\"no_route_from_to_to\":\"{0}에서 {1}(으)로 가는 경로 없음: {2}~{3} 폐쇄됨 ({4})\",\"zone_is_paused_by\":\"구역 {0} {1} 님이 일시정지: {2}\",\"zone_is_stopped_by\":\"구역 {0} {1} 님이 정지: {2}\",\"and_more\":\"{0} 외 {1}\",\"and_cannot_be_reached\":\"{0} 및 {1} 도달 불가: {2}\",\"more\":\"그 외 {0}곳\",\"and_can_be_reached_again\":\"{0} 및 {1} 다시 도달 가능\",\"which_is_on_hold\":\"{0}(보류: {1})\",\"which_is_out_of_service\":\"{0}(사용 중지: {1})\",\"which_is_locked_out_by\":\"{0}({1} 님 정비 잠금: {2})\",\"which_is_off_the_rail\":\"{0}(레일 밖: {1})\",\"is_on_hold\":\"{0} 보류: {1}\",\"is_locked_out_by_2\":\"{0}: {1} 님 정비 잠금: {2}\",\"is_on_hold_2\":\"보류: {0}\",\"is_locked_out_by_3\":\"{0} 님 정비 잠금: {1}\",\"is_out_of_service_2\":\"사용 중지: {0}\",\"is_off_the_rail_3\":\"레일 밖: {0}\",\"is_loaded\":\"캐리어를 싣고 있음\",\"waits\":\"대기: {0}\",\"locked_out_by_2\":\"정비 잠금, 담당자 {0}\",\"empty\":\"비어 있음, {0}\",\"occupied\":\"점유됨, {0}\",\"not_known\":\"상태 모름, {0}\",\"not_known_2\":\"상태 모름\",\"empty_2\":\"비어 있음\",\"occupied_2\":\"점유됨\",\"reported_by\":\"{0} 보고\",\"reserved\":\"예약됨: {0}\",\"reserved_out_of_service\":\"예약됨: {0}, 사용 중지: {1}\",\"reports_cart_but_says_at\":\"{0} 보고는 '{1} cart', {2} 기록은 {3}, 스테이션 {4}\",\"reports_cart_but_says_at_2\":\"보고는 '{0} cart', {1} 기록은 {2}, 스테이션 {3}\",\"that_there_is_a_cart\":\"카트 있음\",\"that_there_is_none\":\"카트 없음\",\"reports_no_cart_but_is_2\":\"{0} 카트 없음 보고, 기록에는 {1} 있음, 스테이션 {2}\",\"reports_an_error_255\":\"{0} 오류(255) 보고\",\"reports_an_error_255_2\":\"{0} 오류(255) 보고; {1}\",\"does_not_know_its_state_2\":\"{0} 자신의 상태를 모름(3)\",\"is_not_open_and_cannot_2\":\"{0} 열려 있지 않고 {1}을(를) 그 앞에서 멈출 수 없음\",\"reports\":\"{0} 보고: {1}\",\"it_is_charging\":\"충전 중\",\"move_by_hand_or_take\":\"다른 길을 찾지 못하면 {0}을(를) 수동으로 옮기거나 레일에서 내리세요\",\"they_go_on\":\"다시 진행함\",\"waits_for_long\":\"{0} 장시간 대기: {1}\",\"mend_that_give_it_another\":\"원인을 해결하거나, 다른 목적지를 주거나(PATCH /api/v1/jobs/{0}), 취소하세요(POST /api/v1/jobs/{1}/cancel)\",\"it_waits_for_that_no_more\":\"더는 그것을 기다리지 않음\",\"it_goes_on\":\"다시 진행함\",\"it_has_ended\":\"종료됨\",\"waits_2\":\"{0} 대기\",\"waits_at_for_held_by_2\":\"{0}: {1}에서 {3} 점유 {2} 대기; {4}: {5}\",\"waits_at_no_slot_is_2\":\"{0}: {1}에서 {2}부터의 대기열에 빈자리 없음. 먼저 나갈 차량: {3}; {4}: {5}\",\"waits_at_others_have_waited_2\":\"{0}: {1}에서 {2}부터의 대기열을 더 오래 기다린 차량이 있음. 먼저 나갈 차량: {3}; {4}: {5}\",\"for_held_by\":\"{0}에서 {2} 점유 {1} 대기\",\"for_held_by_waits_at\":\"{0}에서 {2} 점유 {1} 대기; {3}: {4}\",\"for_held_by_waits_at_2\":\"{0}에서 {2} 점유 {1} 대기; {3}: {4}에서 {6} 점유 {5} 대기\",\"for_held_by_waits_at_3\":\"{0}에서 {2} 점유 {1} 대기; {3}: {4}에서 {6} 점유 {5} 대기; {7}: {8}\",\"no_slot_is_free_in\":\"{0}에서 {1}부터의 대기열에 빈자리 없음. 먼저 나갈 차량: {2}\",\"no_slot_is_free_in_2\":\"{0}에서 {1}부터의 대기열에 빈자리 없음. 먼저 나갈 차량: {2}; {3}: {4}\",\"there_is_no_zone\":\"구역 {0} 없음\",\"the_plant_s_zones_are\":\"플랜트의 구역: {0}\",\"no_edge_leads_from_to\":\"{0}에서 {1}(으)로 이어지는 트랙 없음\",\"the_track_does_not_lead\":\"트랙이 {0}에서 {1}(으)로 이어지지 않음\",\"its_source_would_be_closed\":\"출발지 {0} 폐쇄 예정\",\"its_destination_would_be_closed\":\"목적지 {0} 폐쇄 예정\",\"its_source_would_be_cut\":\"출발지 {0} 도달 불가 예정\",\"its_destination_would_be_cut\":\"목적지 {0} 도달 불가 예정\",\"the_way_of_would_lead\":\"{0}의 경로가 바뀜\",\"leave_expires_out_and_open\":\"expires를 빼고, 모두 나온 뒤 해제하세요\",\"expires_lies_in_the_past\":\"expires가 지난 시각임\",\"name_a_later_moment_or\":\"더 늦은 시각을 지정하거나 빼세요\",\"there_is_no_closure_now\":\"현재 폐쇄 {0} 없음\",\"there_is_no_device\":\"장치 {0} 없음\",\"nothing_it_has_no_packets\":\"없음: 자체 패킷이 없음\",\"it_does\":\"가능한 명령: {0}\",\"is_a_and_does_not\":\"{0}은(는) {1}: {2} 불가\",\"is_kept_open\":\"{0} 열림 유지 중: {1}\",\"is_kept_closed\":\"{0} 닫힘 유지 중: {1}\",\"is_kept_open_by\":\"{0}: {1} 님이 열림 유지\",\"is_kept_closed_by\":\"{0}: {1} 님이 닫힘 유지\",\"is_kept_open_by_2\":\"{0}: {1} 님이 열림 유지: {2}\",\"is_kept_closed_by_2\":\"{0}: {1} 님이 닫힘 유지: {2}\",\"is_kept_open_by_3\":\"{0}: {2} 님이 열림 유지 ({1})\",\"is_kept_closed_by_3\":\"{0}: {2} 님이 닫힘 유지 ({1})\",\"delete_api_v1_devices_pin\":\"먼저 상태 유지를 푸세요 (DELETE /api/v1/devices/{0}/pin)\",\"cannot_close\":\"{0} 닫을 수 없음: {1}\",\"is_granted_the_way_through\":\"{0}에 통과 허가됨\",\"may_stand_in_it\":\"{0}이(가) 그 안에 서 있을 수 있음\",\"may_be_in_it\":\"{0}이(가) 그 안에 있을 수 있음\",\"is_in_it\":\"{0}이(가) 그 안에 있음\",\"has_not_said_where_it\":\"{0}: 시작 후 위치 보고 없음\",\"wait_until_it_is_through\":\"지나갈 때까지 기다리거나, 도어를 정비 잠금하세요: 그 뒤에는 다른 차량에 통과가 허가되지 않음\",\"wait_until_is_done\":\"{0}이(가) 끝날 때까지 기다리세요\",\"is_a_not_a_door\":\"{0}은(는) 도어가 아니라 {1}\",\"name_a_door\":\"도어를 지정하세요\",\"ask\":\"{0} 님에게 문의하세요\",\"wait_a_moment\":\"잠시 기다리세요\",\"is_not_kept_open_or\":\"{0}: 열림·닫힘 유지 상태 아님\",\"is_given_back_to_the\":\"{0}: {1} 님이 차량 제어로 되돌림\",\"is_locked_out_by_4\":\"{0}: {2} 님 정비 잠금 ({1})\",\"is_locked_out_no_more\":\"{0}: {1} 님이 정비 잠금 해제\",\"is_taken_out_of_service\":\"{0}: {2} 님이 사용 중지 ({1})\",\"is_in_service_by\":\"{0}: {1} 님이 사용 재개\",\"is_not_locked_out\":\"{0}: 정비 잠금 상태 아님\",\"not_accepted\":\"수락되지 않음: {0}\",\"look_at_the_device\":\"장치를 확인하세요\",\"does_not\":\"{0} 안 됨: {1}\",\"did_not\":\"{0} 되지 않음: {1}\",\"does_not_2\":\"{0} {1} 안 됨: {2}\",\"did_not_2\":\"{0} {1} 되지 않음: {2}\",\"it_was_settled_before_it\":\"보내기 전에 상태가 확정됨\",\"by_status\":\"상태 보고로 확인: {0}\",\"it_does_not_say_whether\":\"버퍼 잠금 여부는 보고하지 않음\",\"nothing_is_wrong_with_it\":\"더 이상 이상 없음\",\"see_what_is_in_its\":\"도어에서 막고 있는 것을 확인한 뒤 열거나 닫으세요\",\"see_what_is_in_its_2\":\"버퍼에서 막고 있는 것을 확인하세요\",\"on_its_way_is\":\"진행 경로의 {0}: {1}\",\"kept_closed_by\":\"{0} 님이 닫힘 유지: {1}\",\"kept_closed_by_2\":\"{0}({1} 님이 닫힘 유지: {2})\",\"locked_out_by_3\":\"{0}({1} 님 정비 잠금: {2})\",\"out_of_service_2\":\"{0}(사용 중지: {1})\",\"silent_s\":\"{0}(응답 없음: {1}, {2}초)\",\"closing_s\":\"{0}(닫히는 중, {1}초)\",\"opening_s\":\"{0}(열리는 중, {1}초)\",\"moving_s\":\"{0}(움직이는 중, {1}초)\",\"closed_s\":\"{0}(닫힘, {1}초)\",\"error_s\":\"{0}(오류, {1}초)\",\"unknown_s\":\"{0}(상태 모름, {1}초)\",\"silent\":\"응답 없음: {0}\",\"does_first\":\"{0}이(가) 작업 {1}을(를) 먼저 수행\",\"is_nearer_than\":\"{0}이(가) {1}보다 가까움\",\"its_destination_cannot_be_used_2\":\"목적지를 사용할 수 없음: {0}\",\"its_destination_cannot_be_used_3\":\"목적지를 사용할 수 없음: {0} 경로 없음: {1}\",\"its_vehicle_stands_by\":\"차량 대기 중: {0}\",\"is_loaded_already\":\"{0}: 이미 캐리어를 싣고 있음\",\"is_going_on_to_the\":\"{0} {1}. 대체 목적지 {2}(으)로 진행\",\"is_being_taught_by_with_2\":\"{1} 님이 {2}(으)로 {0} 티칭 중 (세션 {3}). 대체 목적지 {4}(으)로 진행\",\"reports_going_on_to_the\":\"{0} 보고: {1}. 대체 목적지 {2}(으)로 진행\",\"finds_no_way_going_on\":\"{0} 경로 없음: {1}. 대체 목적지 {2}(으)로 진행\",\"occupied_by\":\"점유됨({0})\",\"occupied_by_a_carrier\":\"캐리어가 점유함\",\"occupied_its_buffer_reports_a\":\"점유됨: 버퍼가 카트 있음으로 보고\",\"is_occupied_by_a_carrier\":\"{0}에 캐리어가 있음\",\"cannot\":\"{0} {1} 불가: {2}\",\"pick_up\":\"적재\",\"put_down\":\"하역\",\"picking_up\":\"적재 중\",\"putting_down\":\"하역 중\",\"result_0_but_f\":\"RESULT 0이나 F = {0}\",\"at_was_answered_result_0\":\"{1}의 {0}: RESULT 0으로 응답했으나 {2} 비트가 {3}\",\"by_status_2\":\"STATUS로 확인: {0}\",\"by_status_at\":\"STATUS로 확인: {0}에 있음\",\"aborted_look_where_the_carrier\":\"중단됨. {0}: 캐리어 위치를 확인하세요\",\"aborted_without_its_vehicle_look\":\"차량 없이 중단됨: 캐리어 위치를 확인하세요\",\"given_back_by\":\"{0}이(가) 작업 반납: {1}\",\"the_carrier_was_put_down\":\"캐리어를 이미 내려놓음\",\"nothing_is_aboard_2\":\"실린 캐리어 없음\",\"the_key_was_let_go\":\"시작하기 전에 키를 놓음\",\"did_not_answer_again\":\"{0} 다시 응답하지 않음\",\"it_was_broken_off\":\"중단됨\",\"the_controller_was_started_again_2\":\"진행 중에 제어기가 다시 시작됨\",\"ask_again\":\"다시 요청하세요\",\"the_controller_was_started_again_3\":\"쓰기 전에 제어기가 다시 시작됨\",\"the_controller_was_started_again_4\":\"진행 중에 제어기가 다시 시작됨. 보낸 것이 적용되었을 수 있음\",\"look_at_the_drive_s\":\"드라이브 상태를 확인하고 판단하세요\",\"look_at_the_drive_and\":\"드라이브를 확인하고 백업과 비교하세요\",\"being_written\":\"쓰는 중\",\"there_is_no_drive\":\"드라이브 {0} 없음\",\"pressed_stop\":\"{0} 님이 정지를 누름\",\"there_is_no_drive_line\":\"드라이브 회선 {0} 없음\",\"stopped_all_drives_of\":\"{0} 님이 {1}의 모든 드라이브를 정지\",\"it_is_now_not\":\"현재 값은 {1}이(가) 아니라 {0}\",\"read_it_again\":\"다시 읽으세요\",\"is_compared_with_itself\":\"{0}을(를) 자신과 비교함\",\"name_another_drive\":\"다른 드라이브를 지정하세요\",\"a_model_without_a_name\":\"이름 없는 모델\",\"backup_is_of_is\":\"백업 {0}의 모델은 {1}, {2}의 모델은 {3}\",\"a_file_is_of_is\":\"파일의 모델은 {0}, {1}의 모델은 {2}\",\"take_another_backup\":\"다른 백업을 쓰세요\",\"is_running\":\"{0} 운전 중\",\"stop_it_first_then_restore\":\"먼저 정지시킨 뒤 복원하세요\",\"jogs_and_one_axis_of\":\"{0} 님이 {1} 조그 중. 회선 {2}에서는 한 번에 한 축만 조그 가능\",\"wait_until_that_is_over\":\"끝날 때까지 기다리세요\",\"is_in_mode_not_in\":\"{0}: 조그가 아니라 {1} 모드\",\"set_it_to_jog_at\":\"드라이브 패널에서 조그로 바꾸세요\",\"jog_is_over\":\"조그 {0} 종료됨\",\"see_get_api_v1_operations\":\"GET /api/v1/operations/{0}에서 확인하거나 새로 시작하세요\",\"operation_is_not_under_way\":\"드라이브 작업 {0}: 진행 중 아님\",\"a_jog_is_released_not\":\"조그는 취소가 아니라 놓아서 끝냄\",\"delete_its_jog\":\"조그 {0}을(를) 끝내세요 (DELETE)\",\"cancelled_by\":\"{0} 님이 취소\",\"was_locked_out_by\":\"{1} 님이 {0} 정비 잠금\",\"lift_it_first\":\"먼저 해제하세요\",\"line_of_is_not_connected\":\"{1}의 회선 {0} 연결되지 않음: {2}\",\"switch_it_on_see_to\":\"전원을 켜고 케이블과 ID를 확인하세요\",\"is_offline\":\"{0} 오프라인: {1}\",\"wait_for_operation_or_cancel\":\"드라이브 작업 {0}을(를) 기다리거나 취소하세요\",\"is_at\":\"{0} 님이 {1} 작업 중: {2}\",\"operations_of_are_under_way\":\"{1}의 드라이브 작업 {0}건 진행 중\",\"wait_or_cancel_one\":\"기다리거나 하나를 취소하세요\",\"is_in_error_2\":\"{0} 오류 {1}: {2}\",\"parameter_is_read_only\":\"파라미터 {0}: 읽기 전용\",\"leave_it\":\"그대로 두세요\",\"parameter_goes_in_steps_of\":\"파라미터 {0}은(는) {1} 단위: {2} 불가\",\"parameter_is\":\"파라미터 {0} 범위: {1}\",\"parameter_is_not\":\"파라미터 {0} 범위: {1}. {2} 불가\",\"stay_in_that_range\":\"범위 안의 값을 쓰세요\",\"no_catalogue\":\"카탈로그 없음\",\"catalogue\":\"카탈로그 {0}\",\"of_is_in\":\"{1}의 {0}: {2}\",\"of_is_not_in\":\"{1}의 {0}: {2}에 없음\",\"parameter_it_has_a_raw\":\"파라미터 {0}: 원시 값만 있음\",\"send_raw_instead_of_value\":\"value 대신 raw를 보내세요\",\"send_raw_access_true_if\":\"무엇을 하는지 안다면 raw_access: true를 보내세요\",\"parameter_nobody_says_what_it\":\"파라미터 {0}: 허용 값을 알 수 없음\",\"a_raw_value_is_from\":\"원시 값은 0~{0}\",\"of_parameters_gave_no_value\":\"파라미터 {1}개 중 {0}개 값 없음: {2}\",\"the_drive_may_not_have\":\"드라이브에 없는 파라미터일 수 있음: 설명서를 보거나 다시 읽으세요\",\"went_offline\":\"{0} 오프라인이 됨: {1}\",\"did_not_give_parameters_on\":\"{0}: 파라미터 {1}개 연속 응답 없음: {2}\",\"see_to_the_drive_and\":\"드라이브와 회선을 확인한 뒤 다시 요청하세요\",\"gave_no_value\":\"{0} 값 없음: {1}\",\"see_to_the_drive_then\":\"드라이브를 확인한 뒤 다시 요청하세요\",\"parameter_is_not_as_you\":\"파라미터 {0}: 보신 값 {2}이(가) 아니라 {1}\",\"look_at_it_again_then\":\"다시 확인한 뒤 판단하세요\",\"is_running_and_parameter_may\":\"{0} 운전 중: 파라미터 {1}은(는) 운전 중에 쓸 수 없음\",\"stop_it_first_post_api\":\"먼저 정지시키세요 (POST /api/v1/drives/{0}/keys {\\\"key\\\": \\\"stop_reset\\\"})\",\"it_may_be_read_only\":\"읽기 전용이거나 범위 밖일 수 있음: 드라이브 설명서를 확인하세요\",\"parameter_has_still\":\"파라미터 {0} 값이 그대로임: {1}\",\"look_at_the_drive_then\":\"드라이브를 확인한 뒤 다시 쓰세요\",\"parameter_reads_back_as\":\"파라미터 {0}을(를) 다시 읽은 값: {1}\",\"nothing_was_written\":\"쓰지 않음: {0}\",\"skip_read_only\":\"건너뜀: 읽기 전용\",\"skip_not\":\"건너뜀: {0} 아님\",\"parameter_the_rest_was_not\":\"파라미터 {0}: {1}. 나머지는 쓰지 않음\",\"not_restored\":\"복원되지 않음: {0}\",\"compare_the_drive_with_the\":\"드라이브를 백업과 비교하세요\",\"one_to_parameters_can_be\":\"한 번에 파라미터 1~{0}개까지 감시 가능\",\"watch_fewer\":\"수를 줄이세요\",\"watch_parameters_already\":\"이미 {0}곳에서 파라미터 감시 중\",\"end_one_of_those_watches\":\"그중 하나를 끝내세요\",\"there_is_no_watch\":\"감시 {0} 없음\",\"it_may_be_over\":\"이미 끝났을 수 있음\",\"it_answers_again\":\"다시 응답함\",\"answers_again\":\"{0} 다시 응답함\",\"see_its_line_its_address\":\"회선, 주소, 전원을 확인하세요\",\"it_reports_no_error_any\":\"더 이상 오류 보고 없음\",\"by\":\"{0} ({1}): {2} -> {3}, {4} 님\",\"by_2\":\"{0}: {1} -> {2}, {3} 님\",\"when_it_is_over_post\":\"상황이 끝나면 해제하세요 (POST /api/v1/controller/emergency/release)\",\"no_fire_is_told\":\"통보된 화재 없음\",\"no_is_told\":\"통보된 상황 없음 ({0})\",\"fire_is_over\":\"화재 종료: {0} ({1})\",\"earthquake_is_over\":\"지진 종료: {0} ({1})\",\"resume_when_everything_is_in\":\"모두 정상이면 재개하세요\",\"fire\":\"화재: {0} ({1})\",\"earthquake\":\"지진: {0} ({1})\",\"fire_told_by_2\":\"화재, 통보자 {0}: {1}\",\"told_by\":\"{0}, 통보자 {1}: {2}\",\"nothing_moves_fire\":\"아무것도 움직이지 않음: 화재\",\"nothing_moves_earthquake\":\"아무것도 움직이지 않음: 지진\",\"status_standing_at\":\"STATUS: {0}에 서 있음\",\"it_reports_no_alarm_any\":\"더 이상 알람 보고 없음\",\"it_is_stopping_or_stands\":\"정지 중이거나 서 있음\",\"could_not_be_sent_times\":\"{0} {1}회 전송 실패 ({2})\",\"ended_abnormally_times_2\":\"{0} {1}회 비정상 종료 ({2})\",\"is_no_longer_in_the\":\"{0}: 더 이상 플랜트에 없음\",\"job_was_accepted_with_another\":\"작업 {0}이(가) 같은 {1}, 다른 내용으로 이미 접수됨\",\"use_a_new_for_a\":\"새 작업에는 새 {0}을(를) 쓰거나, GET /api/v1/jobs/{1}에서 이전 작업을 확인하세요\",\"job_id_must_not_begin\":\"job_id는 {0}(으)로 시작할 수 없음\",\"leave_it_out_or_use\":\"빼거나 다른 값을 쓰세요\",\"leave_vehicle_out\":\"vehicle을 빼세요\",\"name_another\":\"다른 것을 지정하세요\",\"if_a_carrier_is_there\":\"그곳에 캐리어가 있으면 먼저 기록하세요 (PUT /api/v1/carriers/ID)\",\"else\":\"아니면 {0}\",\"there_is_no_job_under\":\"진행 중인 작업 {0} 없음\",\"post_api_v1_jobs_abort\":\"작업을 중단하세요 (POST /api/v1/jobs/{0}/abort)\",\"post_api_v1_jobs_cancel\":\"작업을 취소하세요 (POST /api/v1/jobs/{0}/cancel)\",\"job_is_aborting\":\"작업 {0} 중단하는 중\",\"job_is_cancelling\":\"작업 {0} 취소하는 중\",\"order_a_new_job_once\":\"끝난 뒤 새 작업을 등록하세요\",\"is_asked_for_2\":\"{0} 지정됨\",\"leave_vehicle_out_only_a\":\"vehicle을 빼세요: 대기 중인 작업만 차량을 바꿀 수 있음\",\"the_carrier_is_being_put\":\"캐리어를 {0}에 내려놓는 중\",\"wait_for_its_end_then\":\"끝날 때까지 기다린 뒤 그곳에서 출발하는 작업을 등록하세요\",\"nothing_changed\":\"변경 없음\",\"priority\":\"우선순위 {0} -> {1}\",\"destination\":\"목적지 {0} -> {1}\",\"vehicle\":\"차량 {0} -> {1}\",\"destination_2\":\"{0}, 목적지 {1} -> {2}\",\"vehicle_2\":\"{0}, 차량 {1} -> {2}\",\"is_a_hoist_and_does\":\"{0}은(는) 호이스트라 {1} 처리 불가\",\"is_an_agv_and_does\":\"{0}은(는) AGV라 {1} 처리 불가\",\"name_another_vehicle_or_leave\":\"다른 차량을 지정하거나 빼세요\",\"see_get_api_v1_stations\":\"처리 가능한 스테이션을 확인하세요 (GET /api/v1/stations)\",\"reports_barcode_at_seq_where\":\"{0}: SEQ {2}에서 바코드 {1} 보고, 경로에는 {3}\",\"the_place_of_is_not\":\"{0}의 위치를 모름\",\"a_door_on_its_way\":\"진행 경로의 도어가 더 이상 열려 있지 않음\",\"is_being_asked_where_it\":\"{0} 위치 확인 중\",\"nobody_knows_where_is_put\":\"{0}의 위치를 모름: 위치를 기록하세요 (PUT /api/v1/carriers/{1})\",\"nobody_gets_away_from_again\":\"{0}에서 다시 나올 수 없음: {1}\",\"no_mode\":\"모드 없음\",\"is_in_mant_needs_auto\":\"{0}은(는) MANT: {1}에는 AUTO 또는 SEMI가 필요함\",\"send_stop\":\"stop을 보내세요\",\"an_alarm_recovery_of_is\":\"{0} 알람 복구 진행 중\",\"stands_where\":\"{0}이(가) 선 곳: {1}\",\"open_that_first\":\"먼저 그 폐쇄를 해제하세요\",\"open_it_first\":\"먼저 폐쇄를 해제하세요\",\"switch_it_to_auto\":\"AUTO로 바꾸세요\",\"switch_it_to_auto_at\":\"AGV에서 auto로 바꾸세요\",\"send_servo_on_search_home\":\"servo_on, search_home, auto를 보내거나 알람 복구를 누르세요\",\"post_api_v1_vehicles_recover\":\"알람 복구를 누르세요 ({0})\",\"post_api_v1_vehicles_release\":\"보류를 해제하세요 ({0})\",\"try_again_shortly\":\"잠시 후 다시 시도하세요\",\"connect_them_or_post_api\":\"연결하거나, verdict off_rail 또는 stands_at으로 해제하세요 (POST /api/v1/vehicles/ID/release). 연결되어 보류 중인 차량은 go_on으로 해제하세요\",\"a_path_ends_in_a\":\"경로는 정지로 끝나야 함\",\"leave_action_out_or_name\":\"action을 빼거나 정지 유형을 지정하세요\",\"end_what_closes_it_kept\":\"폐쇄 원인을 없애세요: GET /api/v1/controller의 kept_off에 있음\",\"it_can_only_now\":\"지금은 {0}만 가능\",\"is_loaded_2\":\"{0}: 캐리어를 싣고 있음\",\"if_it_is_not_so\":\"사실과 다르면 상태를 기록하세요 (PUT /api/v1/stations/{0})\",\"is_not_stopped_at_barcode\":\"{0}이(가) {1}(바코드 {2})이 아니라 {3}에 정지해 있음\",\"send_move_to_with_action\":\"먼저 {0}(으)로 move를 보내세요 (action {1})\",\"is_not_on_hold\":\"{0}: 보류 상태 아님\",\"nothing_to_release\":\"해제할 것 없음\",\"is_connected_and_reports\":\"{0}: 연결되어 보고 중\",\"switch_it_off_and_take\":\"먼저 전원을 끄고 레일에서 내리세요\",\"was_taken_off_the_rail\":\"{0}을(를) 레일에서 내림\",\"said_by\":\"{0} 님 확인: {1}\",\"is_connected_and_reports_its\":\"{0}: 연결되어 위치를 직접 보고 중\",\"use_go_on\":\"go_on을 쓰세요\",\"stands_at\":\"{0} 님: {1}에 서 있음: {2}\",\"was_taken_out_of_service\":\"{0} 사용 중지됨\",\"in_service\":\"{0} 님: 사용 재개\",\"nothing_to_lift\":\"해제할 것 없음\",\"everything_is_stopped_by_2\":\"{0} 님이 전체 정지: {1}\",\"use_a_shorter_id_as\":\"차량 표시 장치에 나오도록 더 짧은 ID를 쓰세요\",\"carrier_must_be_at_most\":\"carrier는 인쇄 가능한 ASCII {0}자 이내여야 함\",\"a_carrier_cannot_be_where\":\"비어 있는 곳에 캐리어가 있을 수 없음\",\"leave_carrier_or_present_out\":\"carrier 또는 present를 빼세요\",\"holds\":\"{0}에 {1}이(가) 있음\",\"carries\":\"{0}에 {1}이(가) 실려 있음\",\"move_or_remove_first\":\"먼저 {0}을(를) 옮기거나 삭제하세요\",\"says_that_nothing_is_aboard\":\"{0} 보고: 캐리어 없음 ({1} 비트 0)\",\"look_where_the_carrier_is\":\"캐리어 위치를 확인해 그곳을 지정하세요\",\"there_is_no_carrier\":\"캐리어 {0} 없음\",\"is_ordered_by_job\":\"{0}: 작업 {1}에 등록됨\",\"cancel_or_abort_the_job\":\"먼저 작업을 취소하거나 중단하세요\",\"removed_from_the_plant\":\"플랜트에서 삭제됨\",\"is_a_side_buffer_vehicles\":\"{0}은(는) 사이드 버퍼: 위치는 차량이 알고 있음\",\"only_ports_have_a_dest\":\"DEST는 포트에만 있습니다\",\"release_it_first_post_api\":\"먼저 비상 상황을 해제하세요 (POST /api/v1/controller/emergency/release)\",\"is_in_alarm_2\":\"{0} 알람 {1}\",\"is_driving\":\"{0} 주행 중\",\"has_its_servos_off_send_2\":\"{0} 서보 꺼짐: SERVO ON, SEARCH HOME, AUTO를 보내세요\",\"has_not_found_its_home_2\":\"{0} 원점을 찾지 못함: SEARCH HOME을 보내세요\",\"has_an_axis_that_is_2\":\"{0}: 원점에 있지 않은 축이 있음\",\"reads_no_barcode_bring_it_2\":\"{0} 바코드를 읽지 못함: 수동으로 바코드 위치로 옮기세요\",\"reports_barcode_which_is_not_2\":\"{0}: 지도에 없는 바코드 {1} 보고 (프로토콜 변형 확인)\",\"it_was_said_to_be\":\"레일 밖으로 기록되었으나({0}) 보고함, 바코드 {1}\",\"reports_barcode_which_it_could\":\"{0}: 옮겨 갈 수 없는 바코드 {1} 보고, 이전 위치 {2}\",\"the_database_is_a_restored\":\"복원한 백업 데이터베이스라 차량의 위치와 적재 기록이 빠졌을 수 있음\",\"compare_its_place_load_and\":\"위치, 적재, 작업을 현장과 비교해 고친 뒤 '보고가 맞음'으로 해제하세요\",\"name_another_one_or_have\":\"다른 것을 지정하거나 그 버전을 거부하세요 (POST /api/v1/layout/versions/{0}/reject)\",\"no_vehicle_is_free_that\":\"{0}(으)로 갈 수 있는 가용 차량 없음\",\"no_parking_place_is_free\":\"{0}이(가) 갈 수 있는 빈 주차 위치 없음\",\"stop_all\":\"전체 정지: {0}\",\"zone_is_stopped\":\"구역 {0} 정지: {1}\",\"zone_goes_on\":\"구역 {0} 재개: {1}\",\"vehicle_is_not_in_the\":\"차량 {0}이(가) 플랜트 파일에 없으나 레일 위에 있을 수 있음 ({1})\",\"put_it_back_into_the\":\"파일에 다시 넣으세요. 레일에서 내린 뒤 그렇게 기록하고(POST /api/v1/vehicles/{0}/release, verdict off_rail) 빼세요.\",\"correct_the_dest_of_the\":\"스테이션의 DEST, 차량의 OFFSET 또는 플랜트 파일의 한계를 고치세요\",\"code_position_barcode_no_code\":\"코드 {0}, 위치 {1}, 바코드 {2}: 티칭 코드 아님\",\"they_did_not_come_within\":\"{0}초 안에 수신되지 않음\",\"answered_without_sending_them\":\"{0}이(가) 보내지 않고 응답함\",\"was_lost\":\"{0} 연결 끊김: {1}\",\"proposal_dest_at\":\"제안 {0}: {2}의 DEST {1}\",\"proposal_dest_at_2\":\"제안 {0}: {2}의 DEST {1}. {3}\",\"proposal_offset_at\":\"제안 {0}: {2}의 OFFSET {1}\",\"proposal_offset_at_2\":\"제안 {0}: {2}의 OFFSET {1}. {3}\",\"by_proposal\":\"제안 {0}(으)로 대체\",\"it_is_version_now_not\":\"현재 버전은 {1}이(가) 아니라 {0}\",\"it_is_revision_now_not\":\"현재 개정은 {1}이(가) 아니라 {0}\",\"read_it_again_then_decide\":\"다시 읽은 뒤 판단하세요\",\"is_a_reference_vehicle_its_2\":\"{0}은(는) 기준 차량: OFFSET은 플랜트 파일에 따라 0\",\"take_reference_out_of_the\":\"먼저 플랜트 파일에서 `reference`를 빼세요\",\"there_is_no_proposal_that\":\"결정을 기다리는 제안 {0} 없음\",\"cannot_be_accepted\":\"{0}은(는) 허용할 수 없음\",\"these_can\":\"허용 가능: {0}\",\"proposal_by_version\":\"제안 {0}, {1} 님: {2} 버전 {3}\",\"proposal_by\":\"제안 {0}, {1} 님: {2}\",\"is_no_port_at_barcode\":\"{0}은(는) 바코드 {1}의 포트가 아님\",\"ports_there\":\"그곳의 포트: {0}\",\"version_is_the_present_one\":\"버전 {0}이(가) 현재 버전\",\"name_an_older_version\":\"이전 버전을 지정하세요\",\"of_rows_of_are_new\":\"{0} 님: {3} {2}행 중 {1}행이 새 버전\",\"there_is_no_open_teaching\":\"열린 티칭 세션 {0} 없음\",\"is_wanted_for_teaching\":\"{1} 티칭에 {0} 사용 예정\",\"session_teaches_with\":\"세션 {0}: {1} 님이 {3}(으)로 {2} 티칭\",\"is_no_port_nothing_is\":\"{0}은(는) 포트가 아님: 티칭 대상 아님\",\"name_a_station_of_kind\":\"포트인 스테이션을 지정하세요\",\"is_no_hoist_it_is\":\"{0}은(는) 호이스트가 아님: 티칭 대상 아님\",\"name_a_hoist\":\"호이스트를 지정하세요\",\"teaches_with_in_session\":\"{0} 님이 {2}(으)로 {1} 티칭 중 (세션 {3})\",\"close_session_first\":\"먼저 세션 {0}을(를) 닫으세요\",\"is_handling_a_carrier_at\":\"{0} {1}에서 캐리어 적재·하역 중\",\"let_it_end_or_choose\":\"끝날 때까지 기다리거나 다른 차량을 고르세요\",\"its_port_or_vehicle_is\":\"포트 또는 차량이 더 이상 플랜트에 없음\",\"close_the_session\":\"세션을 닫으세요\",\"is_sending_its_positions_already\":\"{0}: 이미 위치를 보내는 중\",\"wait_for_its_answer\":\"응답을 기다리세요\",\"stands_at_and_is_at\":\"{0}의 위치는 {1}, {2}의 위치는 {3}\",\"no_barcode_that_it_reads\":\"읽히는 바코드 없음\",\"bring_it_to_barcode_in\":\"바코드 {0}(으)로 옮기세요: AUTO에서 move 명령(action port) 후 stop을 보내세요\",\"session_was_abandoned\":\"세션 {0} 포기됨\",\"session_abandoned_by\":\"세션 {0}: {1} 님이 포기\",\"session_abandoned_by_2\":\"세션 {0}: {1} 님이 포기. {2}\",\"session_closed_by\":\"세션 {0}: {1} 님이 닫음\",\"session_closed_by_2\":\"세션 {0}: {1} 님이 닫음. {2}\",\"listening_for_dev_id\":\"DEV_ID {0} 접속 대기\",\"the_plant_has_no_side\":\"플랜트에 사이드 버퍼 없음\",\"name_the_stations_to_walk\":\"실사할 스테이션을 지정하세요\",\"walk_of_is_at\":\"{1} 님의 재고 실사 {0}에 {2} 포함됨\",\"let_it_end_first\":\"먼저 끝내세요\",\"walk_of\":\"{1} 님의 재고 실사 {0}: {2}\",\"there_is_no_open_walk\":\"진행 중인 재고 실사 {0} 없음\",\"is_not_on_walk\":\"{0}은(는) 재고 실사 {1} 대상이 아님\",\"begin_a_walk_along_it\":\"그곳을 포함해 재고 실사을 시작하세요\",\"leave_carrier_out\":\"carrier를 빼세요\",\"all_that_was_entered_has\":\"입력한 내용이 모두 그 뒤 바뀜\",\"nothing_was_entered\":\"입력된 내용 없음\",\"look_again_or_abandon\":\"다시 확인해 입력하거나 실사를 포기하세요\",\"cannot_be_at_while_nothing\":\"{1}에 아무것도 없다고 했으므로 {0}이(가) 있을 수 없음\",\"leave_carrier_out_or_say\":\"carrier를 빼거나 무언가 있다고 하십시오\",\"not_seen_or_changed_since\":\"확인하지 않았거나 그 뒤 바뀜: {0}\",\"look_there_and_enter_it\":\"현장을 확인해 입력하거나 {\\\"partial\\\": true}를 보내세요\",\"was_seen_at_two_places\":\"{0}이(가) 두 곳에서 확인됨\",\"look_again_and_enter_what\":\"다시 확인해 바르게 입력하세요\",\"places_verified_of_them_were\":\"{0}곳 확인, 그중 {1}곳 불일치\",\"walk_is_accepted_by\":\"재고 실사 {0} {1} 님이 확정: {2}\",\"walk_is_abandoned_by\":\"재고 실사 {0} {1} 님이 포기: {2}\",\"there_is_no_webhook\":\"웹훅 {0} 없음\",\"mend_the_receiver_then_patch\":\"수신 쪽을 고친 뒤 다시 켜세요 (PATCH /api/v1/webhooks/{0} {\\\"active\\\": true})\",\"there_are_webhooks\":\"웹훅이 이미 {0}개 있음\",\"remove_one_that_nobody_needs\":\"쓰지 않는 것을 삭제하세요\",\"the_last_event_is_number\":\"마지막 이벤트는 {0}번\",\"leave_after_out_to_begin\":\"다음 이벤트부터 시작하려면 after를 빼세요\",\"webhook_to_has_not_taken\":\"웹훅 {0}({1}) 전달 실패, 이벤트 {2}, {3}시간 동안 ({4})\",\"webhook_is_removed\":\"웹훅 {0} 삭제됨\",\"webhook_is_active\":\"웹훅 {0} 다시 켜짐: {1}\",\"webhook_is_paused\":\"웹훅 {0} 일시정지: {1}\",\"refused\":\"거부됨: {0}\",\"refused_wrong_name_or_password\":\"거부됨: 이름 또는 암호가 틀림\",\"refused_that_is_not_the\":\"거부됨: 이전 암호가 아님\",\"roles\":\"역할 {0}\",\"roles_for_ever\":\"역할 {0}, 기한 없음\",\"roles_until\":\"역할 {0}, {1}까지\",\"roles_a_new_password\":\"역할 {0}, 새 암호\",\"roles_disabled\":\"역할 {0}, 사용 중지\",\"roles_enabled\":\"역할 {0}, 로그인 가능\",\"roles_disabled_a_new_password\":\"역할 {0}, 사용 중지, 새 암호\",\"roles_enabled_a_new_password\":\"역할 {0}, 로그인 가능, 새 암호\",\"disabled_a_new_password\":\"사용 중지, 새 암호\",\"enabled_a_new_password\":\"로그인 가능, 새 암호\",\"disabled\":\"사용 중지\",\"enabled\":\"로그인 가능\",\"a_new_password\":\"새 암호\",\"from\":\"접속 주소 {0}.{1}.{2}.{3}\",\"instead_of_version\":\"버전 {0} 대신 적용: {1}\",\"instead_of_no_version\":\"이전 버전 없이 적용: {0}\",\"version_goes_on\":\"버전 {0} 계속 운영\",\"a_backup_was_put_back\":\"백업을 되돌림\",\"took_the_wish_back\":\"{0} 님이 적용 요청을 취소: {1}\",\"to_version\":\"버전 {0}(으)로 되돌림: {1}\",\"rows_of_dest\":\"DEST {0}행\",\"rows_of_offset\":\"OFFSET {0}행\",\"operation_released\":\"드라이브 작업 {0}: 키에서 손을 뗌\",\"operation_caller_gone\":\"드라이브 작업 {0}: 요청자 연결 끊김\",\"operation_failed\":\"드라이브 작업 {0} 실패: {1}\",\"operation_unknown\":\"드라이브 작업 {0} 결과 불명: {1}\",\"vehicle_reason\":\"차량 {0}, 사유: {1}\",\"vehicle_verdict_go_on_reason\":\"차량 {0}, 판정: 보고가 맞음, 사유: {1}\",\"vehicle_verdict_off_rail_reason\":\"차량 {0}, 판정: 레일에서 제거됨, 사유: {1}\",\"vehicle_verdict_stands_at_reason\":\"차량 {0}, 판정: 바코드 {2}에 서 있음, 사유: {1}\",\"device_reason\":\"장치 {0}, 사유: {1}\",\"device_position_open_reason\":\"장치 {0}, 열림 고정, 사유: {1}\",\"device_position_closed_reason\":\"장치 {0}, 닫힘 고정, 사유: {1}\",\"drive_reason\":\"드라이브 {0}, 사유: {1}\",\"drive_note\":\"드라이브 {0}, 메모: {1}\",\"zone_reason_stop_false\":\"구역 {0}, 사유: {1}\",\"zone_reason_stop_true\":\"구역 {0}, 주행 차량도 정지, 사유: {1}\",\"kind_fire_reason\":\"화재, 사유: {0}\",\"kind_earthquake_reason\":\"지진, 사유: {0}\",\"place_reason_purpose_traffic\":\"위치 {0}, 통행 폐쇄, 사유: {1}\",\"place_reason_purpose_traffic_expires\":\"위치 {0}, 통행 폐쇄, 사유: {1}, {2}까지\",\"place_reason_purpose_work\":\"위치 {0}, 작업자 폐쇄, 사유: {1}\",\"closure_reason\":\"폐쇄 {0}, 사유: {1}\",\"proposal_reason\":\"제안 {0}, 사유: {1}\",\"proposal_reason_expected\":\"제안 {0}, 사유: {1}, expected {2}\",\"proposal_accept_reason\":\"제안 {0}, accept {1}, 사유: {2}\",\"proposal_accept_reason_expected\":\"제안 {0}, accept {1}, 사유: {2}, expected {3}\",\"session_abandon_false\":\"세션 {0} 종료\",\"session_abandon_true\":\"세션 {0} 종료, 티칭 결과 포기\",\"session_reason_abandon_false\":\"세션 {0} 종료, 사유: {1}\",\"session_reason_abandon_true\":\"세션 {0} 종료, 티칭 결과 포기, 사유: {1}\",\"station_vehicle_note\":\"스테이션 {0}, 차량 {1}, 메모: {2}\",\"walk_reason\":\"재고 실사 {0}, 사유: {1}\",\"walk_partial_false\":\"재고 실사 {0}, 전체 확정\",\"walk_partial_true\":\"재고 실사 {0}, 일부만 확정\",\"alarm_note\":\"알람 {0}, 메모: {1}\",\"reason\":\"사유: {0}\",\"reason_stations\":\"사유: {0}, 스테이션 {1}\",\"choose_another_one\":\"다른 암호를 고르세요.\",\"the_first_user_or_key\":\"첫 사용자나 키에는 admin 역할이 있어야 합니다. 그때부터 모두 로그인해야 합니다.\",\"add_an_administrator_first\":\"먼저 관리자를 추가하세요.\",\"nothing_to_change_was_named\":\"바꿀 내용이 없습니다.\",\"send_roles_disabled_or_password\":\"roles, disabled, password 중 하나를 보내세요.\",\"send_priority_destination_or_vehicle\":\"priority, destination, vehicle 중 하나를 보내세요.\",\"the_controller_is_starting\":\"제어기가 시작하는 중입니다.\",\"asks_too_often\":\"{0}의 요청이 너무 잦습니다.\",\"the_address_asks_too_often\":\"주소 {0}의 요청이 너무 잦습니다.\",\"wait_s_and_ask_less\":\"{0}초 기다리고 요청 간격을 늘리세요.\",\"x_actor_is_a_name\":\"X-Actor는 인쇄 가능한 문자 {0}자 이하의 이름이어야 합니다.\",\"send_a_shorter_or_plainer\":\"더 짧거나 단순한 이름을 보내세요.\",\"the_controller_gave_no_answer\":\"제어기가 {0}초 안에 응답하지 않았습니다.\",\"look_at_the_object_before\":\"다시 요청하기 전에 대상의 상태를 확인하세요. 작업은 같은 id나 키로 다시 보내도 안전합니다.\",\"get_api_v1_lists_them\":\"GET /api/v1/{0}에서 목록을 확인하세요.\",\"get_api_v1_names_its\":\"GET /api/v1/{0}에서 모델을 확인하세요.\",\"get_api_v1_says_since\":\"GET /api/v1/{0}에서 시작 시각을 확인하세요.\",\"see_get_api_v1\":\"GET /api/v1/{0}을(를) 확인하세요.\",\"see_get_api_v1_2\":\"GET /api/v1/{0}을(를) 확인하세요\",\"if_match_is_the_etag\":\"If-Match는 읽은 것의 ETag여야 합니다. 예: \\\"3\\\".\",\"the_end_is_said_twice\":\"끝나는 때가 두 번 적혀 있습니다.\",\"send_expires_or_minutes\":\"expires와 minutes 중 하나만 보내세요.\",\"a_closure_ends_within_a\":\"폐쇄 기한은 1년 이내여야 합니다.\",\"leave_expires_out_to_close\":\"기한 없이 폐쇄하려면 expires를 빼세요.\",\"the_target_is_the_number\":\"대상은 폐쇄 번호여야 합니다.\",\"the_target_is_the_number_2\":\"대상은 재고 실사 번호여야 합니다.\",\"connections_are_open_already\":\"연결이 이미 {0}개 열려 있습니다.\",\"close_some_or_raise_connections\":\"일부를 닫거나 `connections` 설정을 늘리세요.\",\"the_head_of_the_request\":\"요청 헤더가 {0}바이트보다 큽니다.\",\"send_fewer_or_shorter_headers\":\"헤더를 줄여서 보내세요.\",\"a_line_of_the_head\":\"헤더의 한 줄이 {0}바이트보다 길거나 {1}줄을 넘습니다.\",\"speak_http_1_1_without\":\"TLS 없이 HTTP/1.1로 보내세요. TLS는 앞단 프록시에서 처리할 수 있습니다.\",\"the_request_did_not_come\":\"요청이 {0}초 안에 모두 도착하지 않았습니다.\",\"send_it_again_faster\":\"더 빨리 다시 보내세요.\",\"backup_is_of_drive\":\"백업 {0}은(는) 드라이브 {1}의 것입니다.\",\"look_at_drive\":\"드라이브 {0}을(를) 확인하세요.\",\"send_either_raw_or_value\":\"raw와 value 중 하나만 보내세요\",\"send_either_backup_or_drive\":\"backup과 drive 중 하나만 보내세요\",\"has_no_jog\":\"{0}에 조그 {1} 없음.\",\"has_no_watch\":\"{0}에 감시 {1} 없음.\",\"it_may_be_over_2\":\"이미 끝났을 수 있습니다.\",\"watch_already\":\"이미 {0}명이 보고 있습니다.\",\"close_a_page_or_raise\":\"페이지를 닫거나 `watchers` 설정을 늘리세요.\",\"this_server_does_not_answer\":\"이 서버는 {0}(이)라는 이름에 응답하지 않습니다.\",\"use_localhost_or_127_0\":\"localhost나 127.0.0.1을 쓰거나, 이름을 allowed_hosts에 추가하거나, 로그인을 사용하세요 (docs/access.md).\",\"a_page_of_may_not\":\"{0}의 페이지는 이 서버를 호출할 수 없습니다.\",\"use_the_server_s_own\":\"이 서버의 페이지를 쓰거나 출처를 allowed_origins에 추가하세요.\",\"the_body_is_larger_than\":\"본문이 {0}바이트보다 큽니다.\",\"send_it_in_parts\":\"나누어 보내세요.\",\"nothing_is_recorded_for_playback\":\"재생용 기록이 없습니다.\",\"set_playback_days_to_more\":\"playback_days를 0보다 크게 설정하고 서버를 다시 시작하세요.\",\"nothing_was_recorded_by_then\":\"그때까지의 기록이 없습니다.\",\"nothing_was_recorded_in_that\":\"그 시간의 기록이 없습니다.\",\"more_than_changes_in_that\":\"그 시간의 변경이 {0}건을 넘습니다.\",\"ask_for_less\":\"더 적게 요청하세요.\",\"ask_for_longer_ones\":\"더 긴 간격으로 요청하세요.\",\"ask_for_a_shorter_one\":\"더 짧은 기간으로 요청하세요.\",\"more_than_intervals\":\"간격이 {0}개를 넘습니다.\",\"more_than_events_in_this\":\"이 기간의 이벤트가 {0}건을 넘습니다.\",\"from_lies_after_to\":\"from이 to보다 앞서지 않습니다.\",\"exchange_them\":\"둘을 바꾸세요.\",\"at_most_days_at_a\":\"한 번에 {0}일까지입니다.\",\"parquet_needs_pyarrow\":\"Parquet에는 pyarrow가 필요합니다.\",\"pip_install_hoistway_parquet_or\":\"pip install 'hoistway[parquet]'을 실행하거나 CSV로 요청하세요.\",\"is_no_moment_in_iso\":\"ISO 8601 시각이 아님. 예: 2026-07-01T08:30:00Z\",\"is_no_moment_in_iso_2\":\"{0}: ISO 8601 시각이 아님. 예: 2026-07-01T08:30:00Z\",\"out_of_service_needs_a\":\"사용 중지에는 사유가 필요하고, 사용 재개에는 사유가 없습니다.\",\"send_reason_with_in_service\":\"reason은 in_service가 false일 때만 보내세요.\",\"vehicle_has_no_command\":\"차량 {0}에 명령 {1} 없음.\",\"device_has_no_command\":\"장치 {0}에 명령 {1} 없음.\",\"job_id_stands_for_another\":\"작업 id {0}은(는) 이미 다른 주문에 쓰였습니다: 작업 {1}.\",\"idempotency_key_stands_for_another\":\"Idempotency-Key {0}은(는) 이미 다른 주문에 쓰였습니다: 작업 {1}.\",\"send_the_same_body_as\":\"처음과 같은 본문을 보내거나 다른 id를 쓰세요.\",\"idempotency_key_has_1_to\":\"Idempotency-Key는 공백 없는 인쇄 가능한 ASCII 1~128자여야 합니다.\",\"there_are\":\"있는 것: {0}.\",\"after_is_the_number_of\":\"after는 이벤트 번호여야 합니다.\",\"send_the_seq_of_the\":\"마지막으로 본 이벤트의 seq를 보내세요.\",\"you_have_to_say_who\":\"다시 로그인해야 합니다.\",\"send_resync_true_topics_vehicles\":\"{\\\"resync\\\": true}, {\\\"topics\\\": [\\\"vehicles\\\"]}, {\\\"id\\\": 1, \\\"command\\\": {...}} 중 하나를 보내세요.\",\"a_message_has_at_most\":\"메시지는 {0}자까지입니다.\",\"the_message_asks_for_nothing\":\"메시지에 요청이 없습니다.\",\"the_message_is_not_understood\":\"메시지를 해석할 수 없습니다: {0}\",\"the_body_came_as\":\"본문 형식이 {0}입니다.\",\"send_the_header_content_type\":\"헤더 Content-Type: {0}을(를) 보내세요.\",\"send_the_header_content_type_2\":\"헤더 Content-Type: text/csv 또는 application/json을 보내세요.\",\"report_it_with_the_server\":\"이 시각의 서버 로그와 함께 알려 주세요. 요청이 어떻게 되었는지는 알 수 없습니다.\",\"the_request_met_a_defect\":\"요청 처리 중 서버 결함이 나타났습니다.\",\"there_is_no_2\":\"/{0} 경로 없음.\",\"the_paths_are_listed_at\":\"경로는 /api/docs에 있습니다.\",\"does_not_have\":\"{0}에는 {1} 메서드가 없습니다.\",\"it_has_get\":\"쓸 수 있는 메서드: GET{0}.\",\"it_has\":\"쓸 수 있는 것: {0}.\",\"it_has_stopped\":\"멈췄습니다.\",\"there_is_no_stream_at\":\"{0}에 스트림이 없습니다.\",\"the_live_stream_is_at\":\"실시간 스트림은 /api/v1/live에 있습니다.\",\"the_body_is_not_json\":\"본문이 JSON이 아닙니다.\",\"the_body_is_not_json_2\":\"본문이 JSON이 아닙니다: {0}.\",\"there_is_no_such_field\":\"그런 항목이 없음\",\"a_body_in_json_is\":\"JSON 본문이 필요합니다\",\"a_json_object_is_required\":\"JSON 객체가 필요함\",\"the_body_has_to_be\":\"본문은 JSON 객체여야 합니다\",\"is_required\":\"필수 항목\",\"is_none_of\":\"{0} 중 하나가 아님\",\"holds_a_character_that_is\":\"허용되지 않는 문자가 있음 (제어 문자는 항상 불가)\",\"there_is_no_such_field_2\":\"{0}: 그런 항목이 없음\",\"a_json_object_is_required_2\":\"{0}: JSON 객체가 필요함\",\"is_required_2\":\"{0}: 필수 항목\",\"is_none_of_2\":\"{0}: {1} 중 하나가 아님\",\"holds_a_character_that_is_2\":\"{0}: 허용되지 않는 문자가 있음 (제어 문자는 항상 불가)\",\"input_should_be_a_valid\":\"{0}: 문자열이어야 함\",\"input_should_be_a_valid_2\":\"{0}: 숫자여야 함\",\"input_should_be_a_valid_3\":\"{0}: 정수여야 함\",\"input_should_be_a_valid_4\":\"{0}: 숫자여야 함\",\"input_should_be_a_valid_5\":\"{0}: 정수여야 함\",\"input_should_be_a_valid_6\":\"{0}: true 또는 false여야 함\",\"input_should_be_a_valid_7\":\"{0}: 목록이어야 함\",\"input_should_be_greater_than\":\"{0}: {1}보다 커야 함\",\"input_should_be_greater_than_2\":\"{0}: {1} 이상이어야 함\",\"input_should_be_less_than\":\"{0}: {1}보다 작아야 함\",\"input_should_be_less_than_2\":\"{0}: {1} 이하여야 함\",\"input_should_be\":\"{0}: '{1}' 중 하나여야 함\",\"string_should_have_at_least\":\"{0}: {1}자 이상이어야 함\",\"string_should_have_at_least_2\":\"{0}: {1}자 이상이어야 함\",\"string_should_have_at_most\":\"{0}: {1}자 이하여야 함\",\"this_server_keeps_nobody_who\":\"이 서버에는 로그인할 수 있는 사용자가 없습니다.\",\"keep_the_plant_in_a\":\"플랜트를 데이터베이스에 보관하세요.\",\"nobody_has_to_log_in\":\"이곳은 로그인이 필요 없어 로그인한 사람이 없습니다.\",\"add_a_user_first_post\":\"먼저 사용자를 추가하세요: POST /api/v1/users.\",\"commands_of_yours_are_under\":\"보낸 명령 {0}개가 진행 중입니다.\",\"wait_for_their_replies\":\"응답을 기다리세요.\",\"did_you_mean\":\"{0}을(를) 뜻하셨습니까?\",\"send_actor_name\":\"\\\"actor\\\": \\\"NAME\\\"을 보내세요.\",\"this_command_has_no_body\":\"이 명령에는 본문이 없습니다.\",\"leave_it_out\":\"빼고 보내세요.\",\"nothing_to_write_was_named\":\"쓸 내용이 없습니다.\",\"send_present_carrier_reserved_or\":\"present, carrier, reserved, out_of_service 중 하나를 보내세요.\",\"vehicles_know_the_positions_of\":\"사이드 버퍼의 위치는 차량이 스스로 압니다.\",\"is_no_port_it_has\":\"{0}은(는) 포트가 아니어서 DEST가 없습니다.\",\"it_has_versions_1_to\":\"버전 1~{0}이(가) 있습니다.\",\"it_was_never_taught\":\"티칭한 적이 없습니다.\",\"has_no_version\":\"{0}에 버전 {1} 없음.\",\"nothing_was_imported_of_rows\":\"가져온 것 없음: {1}행 중 {0}행이 잘못됨, 첫 번째는 {2}행.\",\"correct_them_dry_run_true\":\"잘못된 행을 고치세요. dry_run=true로 모든 행을 확인할 수 있습니다.\",\"export_a_file_and_edit\":\"파일을 내보낸 뒤 그것을 고쳐서 쓰세요.\",\"is_no_whole_number\":\"{0}은(는) 정수가 아님\",\"the_file_is_not_utf\":\"파일이 UTF-8이 아닙니다.\",\"save_it_as_csv_in\":\"UTF-8 CSV로 저장하세요.\",\"line_is_no_csv\":\"{0}행이 CSV가 아닙니다: {1}.\",\"the_first_line_names_the\":\"첫 행에 열 이름을 쉼표로 구분해 적으세요: {0}.\",\"the_file_has_no_column\":\"파일에 {0} 열이 없습니다.\",\"line_1_unknown_column\":\"1행: 알 수 없는 열 {0}\",\"did_you_mean_2\":\"{0}을(를) 뜻하셨습니까?\",\"known\":\"쓸 수 있는 것: {0}\",\"a_column_stands_twice\":\"같은 열이 두 번 있습니다.\",\"keep_one_of_them\":\"하나만 남기세요.\",\"the_body_is_no_list\":\"본문이 행 목록이 아닙니다.\",\"send_items_shft_0_rota\":\"{\\\"items\\\": [{\\\"{0}\\\": \\\"...\\\", \\\"shft\\\": 0, \\\"rota\\\": 0, \\\"lift\\\": 0}]} 형식으로 보내세요.\",\"the_file_has_more_than\":\"파일이 {0}행을 넘습니다.\",\"there_is_no_column_here\":\"이곳에 {0} 열 없음\",\"take_it_out\":\"빼세요\",\"proposal_is_pending\":\"제안 {0} 상대 값 필요: {1}\",\"proposal_is_ready\":\"제안 {0} 승인 대기: {1}\",\"proposal_is_ambiguous\":\"제안 {0} 포트 불명확: {1}\",\"proposal_is_approved\":\"제안 {0} 승인됨: {1}\",\"proposal_is_rejected\":\"제안 {0} 반려됨: {1}\",\"proposal_is_collecting\":\"제안 {0} 수집 중: {1}\",\"proposal_is_incomplete\":\"제안 {0} 불완전: {1}\",\"proposal_is_out_of_range\":\"제안 {0} 범위 초과: {1}\",\"proposal_is_unusable\":\"제안 {0} 사용 불가: {1}\",\"proposal_is_wrong_mode\":\"제안 {0} 모드 오류: {1}\",\"proposal_is_unknown_barcode\":\"제안 {0} 바코드 불명: {1}\",\"close_it_its_port_or\":\"세션을 닫으세요. 포트나 차량이 더 이상 플랜트에 없습니다\",\"stands_at_needs_the_barcode\":\"barcode는 stands_at에만 필요하며, stands_at에는 꼭 있어야 합니다.\",\"send_barcode_with_stands_at\":\"stands_at에 barcode를 함께 보내거나, 그 외에는 빼세요.\",\"version_has_no_catalogue\":\"버전 {0}에 카탈로그 {1} 없음.\",\"version_is_active_not\":\"운영 중인 버전은 {1}이(가) 아니라 {0}입니다.\",\"look_at_what_differs_from\":\"운영 중인 버전과의 차이를 확인하세요.\",\"see_errors_for_all_of\":\"전체는 errors를 확인하세요. 먼저 그것을 끝내거나 wait: true를 보내세요.\",\"this_server_keeps_no_versions\":\"이 서버는 플랜트 버전을 보관하지 않습니다.\",\"start_it_with_hoistway_serve\":\"파일이나 서버의 데이터베이스로 hoistway serve를 시작하세요.\",\"the_plant_file_is_not\":\"플랜트 파일이 UTF-8이 아닙니다: {1}바이트에서 {0}.\",\"save_it_as_utf_8\":\"UTF-8로 저장하세요.\",\"stage_a_file_that_this\":\"이 프로그램이 해석할 수 있는 파일을 올리세요.\",\"version_cannot_be_used_by\":\"이 프로그램에서 버전 {0}을(를) 쓸 수 없습니다: {1}.\",\"the_text_of_version_is\":\"버전 {0}의 파일 내용은 더 이상 보관하지 않습니다. 거부됨: {1}.\",\"stage_it_again_if_somebody\":\"파일이 있고 다시 필요하면 새로 올리세요.\",\"the_plant_file_has_error\":\"플랜트 파일에 오류 {0}개. {1}행 {2}열: {3}.\",\"the_plant_file_has_errors\":\"플랜트 파일에 오류 {0}개. {1}행 {2}열: {3}.\",\"correct_the_plant_file_and\":\"플랜트 파일을 고치고 hoistway check로 확인하세요.\",\"there_is_no_event\":\"이벤트 {0} 없음\",\"nothing_may_be_sent_there\":\"그곳에는 보낼 수 없습니다: {0}.\",\"there_is_no_user\":\"사용자 {0} 없음.\",\"there_is_no_key\":\"키 {0} 없음.\",\"there_is_no_job\":\"작업 {0} 없음.\",\"there_is_no_vehicle_2\":\"차량 {0} 없음.\",\"there_is_no_station_2\":\"스테이션 {0} 없음.\",\"there_is_no_carrier_2\":\"캐리어 {0} 없음.\",\"there_is_no_device_2\":\"장치 {0} 없음.\",\"there_is_no_drive_2\":\"드라이브 {0} 없음.\",\"there_is_no_link\":\"링크 {0} 없음.\",\"there_is_no_zone_2\":\"구역 {0} 없음.\",\"there_is_no_alarm_2\":\"알람 {0} 없음.\",\"there_is_no_closure\":\"폐쇄 {0} 없음.\",\"there_is_no_walk\":\"재고 실사 {0} 없음.\",\"there_is_no_operation\":\"드라이브 작업 {0} 없음.\",\"there_is_no_backup\":\"백업 {0} 없음.\",\"there_is_no_webhook_2\":\"웹훅 {0} 없음.\",\"there_is_no_problem\":\"문제 유형 {0} 없음.\",\"there_is_no_controller\":\"제어기 {0} 없음.\",\"there_is_no_proposal\":\"제안 {0} 없음.\",\"there_is_no_teaching_session\":\"티칭 세션 {0} 없음.\",\"there_is_no_parameter\":\"매개변수 {0} 없음.\",\"there_is_no_time_zone\":\"시간대 {0} 없음.\",\"such_as_asia_seoul\":\"예: Asia/Seoul, Europe/Berlin, UTC.\",\"this_machine_has_no_time_zones\":\"이 서버에 시간대 정보가 없습니다.\",\"pip_install_tzdata\":\"pip install tzdata를 실행하거나 tz를 빼십시오.\",\"from_lies_in_the_future\":\"from이 미래 시각입니다.\",\"a_period_up_to_now\":\"to를 적지 않으면 현재까지의 기간입니다.\",\"there_are_none_here\":\"여기에는 매개변수가 없습니다.\",\"is_given_more_than_once\":\"{0}이(가) 두 번 이상 지정되었습니다.\",\"give_it_once\":\"한 번만 지정하세요.\",\"there_is_no_language\":\"언어 {0} 없음.\",\"this_command_is_about_one\":\"이 명령은 대상 하나를 지정해야 합니다.\",\"send_its_id_as_target\":\"\\\"target\\\"에 대상 ID를 보내세요.\",\"ask_for_a_period_that_has\":\"이미 시작된 기간을 지정하세요.\",\"there_is_no_event_yet\":\"이벤트 {0}은(는) 아직 없습니다: 최신 번호는 {1}입니다.\",\"if_the_database_is_another\":\"데이터베이스가 바뀌었다면 after=0부터 시작하세요.\",\"there_is_no_topic\":\"항목 {0} 없음.\",\"there_is_no_command\":\"명령 {0} 없음.\",\"there_is_no_version\":\"버전 {0} 없음.\",\"there_is_no_version_of\":\"플랜트 버전 {0} 없음.\",\"it_has_not_reported_yet\":\"아직 보고가 없음\",\"wait_for_it\":\"기다리세요\",\"is_an_agv_and_enig\":\"{0}: AGV이며 ENIG에는 표시 명령이 없음\",\"is_an_agv_and_enig_2\":\"{0}: AGV이며 ENIG에는 그런 명령이 없음\",\"it_stands_or_is_about\":\"서 있거나 곧 정지함\",\"stopped_before_it_set_out\":\"출발 전에 정지됨\",\"stopped_on_its_way\":\"이동 중에 정지됨\",\"may_choose_another_way_from\":\"{0}: {1}에서 {2}(으)로 허가된 길과 다른 길을 택할 수 있음\",\"correct_the_lengths_of_the\":\"그곳의 트랙 길이를 고치거나 한쪽 길을 일방통행으로 바꾸세요\",\"status_does_not_show_it\":\"상태 보고의 위치가 {0}이(가) 아니라 {1}\",\"its_lift_is_up_and\":\"리프트 상승 위치, {0}\",\"its_lift_is_down_and\":\"리프트 하강 위치, {0}\",\"its_lift_is_unknown_and\":\"리프트 위치 불명, {0}\",\"no_cart_is_on_it\":\"카트 없음\",\"a_cart_is_on_it\":\"카트 있음\",\"it_does_not_know_whether\":\"카트 유무를 알지 못함\",\"has_its_lift_neither_up\":\"리프트가 상승도 하강도 아님: 기다리거나 agv_lift up 또는 down을 보내세요\",\"does_not_know_whether_a\":\"카트 유무를 알지 못함: 확인하고 AGV에서 바로잡으세요\",\"moves_taken_255_is_followed\":\"수락한 이동 수, 255 다음은 1\",\"none_yet\":\"아직 없음\",\"the_device_reports_no_more\":\"장치가 더 이상 보고하지 않음\",\"another_command_was_sent_before\":\"결과가 나타나기 전에 다른 명령을 보냄\",\"over_current_second_level\":\"과전류 2단계\",\"over_current\":\"과전류\",\"overheated\":\"과열\",\"over_voltage\":\"과전압\",\"under_voltage\":\"저전압\",\"braking_transistor\":\"제동 트랜지스터 이상\",\"overload\":\"과부하\",\"overload_second_level\":\"과부하 2단계\",\"cb0_look_it_up_in\":\"CB0: 드라이브 설명서를 확인하세요\",\"cb1_look_it_up_in\":\"CB1: 드라이브 설명서를 확인하세요\",\"cb2_look_it_up_in\":\"CB2: 드라이브 설명서를 확인하세요\",\"se_look_it_up_in\":\"SE: 드라이브 설명서를 확인하세요\",\"communication_error\":\"통신 오류\",\"mark_sensor\":\"마크 센서 이상\",\"home_search_failed\":\"원점 찾기 실패\",\"external_error_input\":\"외부 오류 입력\",\"not_in_the_specification\":\"사양에 없음\",\"01_oc2_over_current_second\":\"01 OC2: 과전류 2단계\",\"02_oc_over_current\":\"02 OC: 과전류\",\"03_oh_overheated\":\"03 OH: 과열\",\"04_ov_over_voltage\":\"04 OV: 과전압\",\"05_uv_under_voltage\":\"05 UV: 저전압\",\"06_btr_braking_transistor\":\"06 BTR: 제동 트랜지스터 이상\",\"07_ol1_overload\":\"07 OL1: 과부하\",\"08_ol2_overload_second_level\":\"08 OL2: 과부하 2단계\",\"09_cb0_cb0_look_it\":\"09 CB0: 드라이브 설명서를 확인하세요\",\"10_cb1_cb1_look_it\":\"10 CB1: 드라이브 설명서를 확인하세요\",\"11_cb2_cb2_look_it\":\"11 CB2: 드라이브 설명서를 확인하세요\",\"12_com_err_communication_error\":\"12 COM_ERR: 통신 오류\",\"13_mark_err_mark_sensor\":\"13 MARK_ERR: 마크 센서 이상\",\"14_home_err_home_search\":\"14 HOME_ERR: 원점 찾기 실패\",\"15_se_se_look_it\":\"15 SE: 드라이브 설명서를 확인하세요\",\"16_ext_err_external_error\":\"16 EXT_ERR: 외부 오류 입력\",\"look_for_a_short_circuit\":\"모터와 케이블의 단락을 점검한 뒤 Stop/Reset을 누르세요\",\"look_for_a_jammed_axis\":\"축 걸림을 점검하거나 가속 시간을 늘린 뒤 Stop/Reset을 누르세요\",\"let_it_cool_see_to\":\"식힌 다음 팬과 부하를 점검하고 Stop/Reset을 누르세요\",\"lengthen_the_deceleration_or_see\":\"감속 시간을 늘리거나 제동 저항과 전원을 점검한 뒤 Stop/Reset을 누르세요\",\"see_to_the_mains_and\":\"전원과 퓨즈를 점검한 뒤 Stop/Reset을 누르세요\",\"see_to_the_brake_resistor\":\"제동 저항을 점검하고 감속 시간을 늘린 뒤 Stop/Reset을 누르세요\",\"free_the_axis_or_lessen\":\"축 걸림을 풀거나 부하를 줄인 뒤 Stop/Reset을 누르세요\",\"free_the_axis_let_the\":\"축 걸림을 풀고 모터를 식힌 뒤 Stop/Reset을 누르세요\",\"remove_its_cause_then_press\":\"원인을 없앤 뒤 Stop/Reset을 누르세요\",\"see_to_the_cable_and\":\"케이블, 드라이브 ID, 통신 속도를 점검한 뒤 Stop/Reset을 누르세요\",\"clean_and_align_the_mark\":\"마크 센서를 청소하고 정렬한 뒤 Stop/Reset을 누르세요\",\"see_to_the_home_sensor\":\"원점 센서와 그 경로를 점검한 뒤 Stop/Reset을 누르고 원점 찾기를 다시 하세요\",\"remove_what_sets_the_external\":\"외부 입력의 원인을 없앤 뒤 Stop/Reset을 누르세요\",\"look_it_up_in_the\":\"드라이브 설명서를 확인한 뒤 Stop/Reset을 누르세요\",\"epoch_is_outside_1\":\"epoch {0}: 1..{1} 범위 밖\",\"the_cmd_id_counter_of\":\"이 epoch의 CMD_ID 카운터 소진: 제어기를 다시 시작하세요\",\"there_is_no_port_to\":\"쓸 수 있는 포트 {0} 없음\",\"there_is_no_hoist_to\":\"쓸 수 있는 호이스트 {0} 없음\",\"is_on_line_already\":\"{0}은(는) 이미 {1}행에 있음\",\"keep_one_of_them_2\":\"하나만 남기세요\",\"is_at_version_now_not\":\"{0}의 현재 버전은 {2}이(가) 아니라 {1}\",\"export_again_then_edit\":\"다시 내보낸 뒤 고치세요\",\"has_no_value\":\"{0}에 값이 없음\",\"give_shft_rota_and_lift\":\"shft, rota, lift 전부 또는 바뀌는 것을 적으세요\",\"stay_unknown_jobs_stay_refused\":\"{0} 여전히 모름: 작업은 계속 거부됨\",\"shft_is_outside_2\":\"SHFT {0}: {1}..{2} 범위 밖\",\"rota_is_outside_2\":\"ROTA {0}: {1}..{2} 범위 밖\",\"lift_is_outside_2\":\"LIFT {0}: {1}..{2} 범위 밖\",\"closed_for_people_at_work_2\":\"작업자 폐쇄\",\"a_path_has_at_least\":\"경로에는 요소가 하나 이상 있고 마지막은 정지여야 함\",\"seq_to_is_outside_0\":\"SEQ {0}~{1}: 0..{2} 범위 밖\",\"no_route_from_to\":\"{0}에서 {1}(으)로 가는 경로 없음\",\"no_route_from_to_is_3\":\"{0}에서 {1}(으)로 가는 경로 없음: {2}은(는) 트랙에 없음\",\"no_route_from_to_the\":\"{0}에서 {1}(으)로 가는 경로 없음: 트랙이 이어지지 않음\",\"open_to\":\"{0}~{1} 폐쇄를 해제하세요\",\"this_controller_has_stopped\":\"이 제어기는 멈췄습니다.\",\"ask_the_one_that_holds\":\"지금 플랜트를 맡은 제어기에 요청하거나 이 제어기를 다시 시작하세요.\",\"the_plant_was_changed_meanwhile\":\"그사이 플랜트가 바뀜: 운영 중인 버전은 {1}이(가) 아니라 {0}\",\"the_plant_was_changed_meanwhile_2\":\"그사이 플랜트가 바뀜: 버전 {0}이(가) 아니며 운영 중인 버전 없음\",\"start_again\":\"다시 시작하세요.\",\"a_defect_stopped_the_controller\":\"결함으로 제어기가 멈춤. 로그를 확인하세요\",\"the_lease_on_the_plant\":\"프로세스가 멈췄거나 데이터베이스가 끊긴 동안 플랜트 점유권이 만료됨\",\"a_newer_hoistway_has_written\":\"더 새로운 Hoistway가 쓴 파일\",\"open_it_with_that_one\":\"그 버전으로 여세요.\",\"this_is_no_recorded_incident\":\"기록 파일이 아님: {0}\",\"get_one_with_get_api\":\"GET /api/v1/history/export로 받으세요.\",\"it_sent_more_than_bytes\":\"1초에 {0}바이트 넘게 보냄\",\"the_connection_was_closed\":\"연결이 닫힘\",\"is_not_the_address_of\":\"{0}은(는) 접속이 허용된 차량의 주소가 아님\",\"claims_to_be_which_is\":\"{0}이(가) 이미 연결된 {1}(이)라고 알림\",\"connections_are_being_asked_who\":\"신원 확인 중인 연결이 이미 {0}개\",\"has_dev_id_which_no\":\"{0}의 DEV_ID {1}: 그 주소에서 접속할 수 있는 차량에 없음\",\"answers_to_no_id_that\":\"{0}: 연결을 기다리는 어느 ID에도 응답하지 않음\",\"nothing_was_made_durable_or\":\"{0}초 동안 저장하거나 시도한 것이 없음\",\"a_password_has_to_characters\":\"암호는 {0}~{1}자여야 합니다.\",\"no_folder_for_temporary_files\":\"임시 파일용 폴더 없음\",\"is_no_person_who_logged\":\"{0}은(는) 로그인한 사람이 아닙니다.\",\"a_key_is_good_until\":\"키는 만료될 때까지 유효합니다.\",\"delete_api_v1_keys_name\":\"키는 DELETE /api/v1/keys/NAME으로 끝냅니다.\",\"log_in_with_name_and\":\"이름과 암호로 로그인하세요.\",\"this_is_a_recording\":\"기록을 재생하는 화면입니다.\",\"ask_the_controller_of_the\":\"플랜트의 제어기에 요청하세요.\",\"a_recording\":\"기록 재생\",\"traces_are_wanted_and_is\":\"추적이 켜져 있으나 {0}이(가) 설치되지 않음\",\"install_hoistway_otel_or_leave\":\"hoistway[otel]을 설치하거나 추적을 끄세요.\",\"no_answer_in_s\":\"{0}초 안에 응답 없음\",\"no_answer_within_s\":\"{0}초 안에 응답 없음\",\"it_is_a_file_of\":\"플랜트 {0}의 파일이며 이곳은 {1}입니다.\",\"write_name_into_it_if\":\"이 플랜트의 파일이 맞으면 name: {0}을(를) 적으세요.\",\"says_that_it_is_gone\":\"영구히 없어졌다고 응답함(410)\",\"has_not_taken_event_for\":\"이벤트 {0}을(를) {1}시간 동안 받지 않음({2})\",\"events_to_are_no_longer\":\"이벤트 {0}~{1}은(는) 더 이상 보관하지 않음\",\"name_the_host_domain_address\":\"호스트, *.도메인, 주소, 네트워크 중 하나를 환경 변수 HOISTWAY_WEBHOOK_TARGETS나 설정 파일의 webhook_targets에 적고 제어기를 다시 시작하세요.\",\"set_hoistway_webhook_targets_or\":\"환경 변수 HOISTWAY_WEBHOOK_TARGETS나 설정 파일의 webhook_targets를 정하세요\",\"write_a_url_of_http\":\"http나 https URL을 이름, 비밀번호, # 뒷부분 없이 적으세요.\",\"it_is_no_url\":\"URL이 아님: {0}\",\"it_is_no_url_of\":\"http 또는 https URL이 아님\",\"a_url_with_a_name\":\"이름이나 암호가 든 URL은 로그에 남음\",\"a_fragment_is_never_sent\":\"URL의 # 뒷부분은 전송되지 않음\",\"this_server_may_send_to\":\"이 서버에 허용된 대상이 없음\",\"is_not_among_the_targets\":\"{0}은(는) 허용된 대상이 아님\",\"leads_to_which_is_not\":\"{0}의 주소 {1}은(는) 허용되지 않음\",\"leads_to_no_address_which\":\"{0}에 해당하는 주소 없음\",\"webhook_targets_is_no_host\":\"webhook_targets: {0}은(는) 호스트, 주소, 네트워크가 아님\",\"write_such_as_mes_fab\":\"mes.fab, mes.fab:8443, *.fab, 10.1.2.3, 10.0.0.0/8처럼 적으세요.\",\"the_thread_that_writes_the\":\"데이터베이스 기록 스레드 중단. 로그를 확인하세요\",\"a_database_in_memory_keeps\":\"메모리 데이터베이스에는 로그인할 사용자를 보관할 수 없음\",\"a_database_in_memory_keeps_2\":\"메모리 데이터베이스에는 플랜트 버전을 보관할 수 없음\",\"a_database_in_memory_can\":\"메모리 데이터베이스는 자체 원장으로만 읽을 수 있음\",\"a_database_in_memory_cannot\":\"메모리 데이터베이스에는 백업을 되돌릴 수 없음\",\"keep_the_plant_in_a_2\":\"플랜트를 파일에 보관하세요.\",\"write_sqlite_var_plant_db\":\"sqlite:///var/plant.db처럼 적으세요.\",\"write_sqlite_var_plant_db_2\":\"sqlite:///var/plant.db 또는 postgresql://user@host/database처럼 적으세요.\",\"key_is_revoked_already\":\"키 {0}은(는) 이미 폐기되었습니다.\",\"nothing_more_has_to_be\":\"더 할 일이 없습니다.\",\"nothing_has_to_be_done\":\"할 일이 없습니다.\",\"choose_another_name_none_is\":\"다른 이름을 고르세요. 감사 기록을 오래 알아볼 수 있도록 이름은 다시 쓰지 않습니다.\",\"there_is_a_user_already\":\"사용자 {0}이(가) 이미 있습니다.\",\"there_is_a_key_already\":\"키 {0}이(가) 이미 있습니다.\",\"make_somebody_else_an_administrator\":\"먼저 다른 사람을 관리자로 만드세요: hoistway users add NAME --role admin.\",\"users_and_keys_cannot_be\":\"사용자와 키를 읽을 수 없음: {0}\",\"a_password_cannot_be_kept\":\"암호를 저장할 수 없음: {0}\",\"the_session_cannot_be_renewed\":\"세션을 갱신할 수 없음: {0}\",\"the_use_of_keys_cannot\":\"키 사용 기록을 저장할 수 없음: {0}\",\"the_change_cannot_be_kept\":\"변경을 저장할 수 없음: {0}\",\"the_audit_cannot_be_written\":\"감사 기록을 쓸 수 없음: {0}\",\"there_is_no_database\":\"데이터베이스 {0} 없음\",\"see_url\":\"--url을 확인하세요.\",\"see_url_and_the_file\":\"--url과 파일을 확인하세요.\",\"there_is_no_backup_2\":\"백업 {0} 없음\",\"name_a_file_that_hoistway\":\"hoistway db backup이 쓴 파일을 지정하세요.\",\"is_no_backup_of_a\":\"{0}은(는) 플랜트 백업이 아님: {1}\",\"is_damaged\":\"{0} 손상됨: {1}\",\"take_an_earlier_backup\":\"더 이전 백업을 쓰세요.\",\"is_the_database_itself\":\"{0}은(는) 데이터베이스 자체임\",\"name_the_backup\":\"백업 파일을 지정하세요.\",\"the_lease_of_the_plant\":\"플랜트 점유권을 갱신할 수 없음: {0}\",\"the_lease_of_the_plant_2\":\"플랜트 점유권을 얻을 수 없음: {0}\",\"the_lease_cannot_be_renewed\":\"점유권을 갱신할 수 없음: {0}\",\"bring_it_up_to_date\":\"최신으로 올리세요: hoistway db upgrade.\",\"there_is_nothing_to_keep\":\"아직 보관할 것이 없습니다.\",\"the_database_has_schema_not\":\"데이터베이스 스키마가 {1}이(가) 아니라 {0}\",\"the_database_has_schema_none\":\"데이터베이스에 스키마 없음 ({0} 필요)\",\"the_database_cannot_be_opened\":\"데이터베이스를 열 수 없음: {0}\",\"the_database_cannot_be_read\":\"데이터베이스를 읽을 수 없음: {0}\",\"the_database_cannot_be_read_2\":\"데이터베이스를 읽을 수 없음: 스키마가 {1}이(가) 아니라 {0}\",\"the_database_cannot_be_read_3\":\"데이터베이스를 읽을 수 없음: 플랜트 없음\",\"the_database_cannot_be_copied\":\"데이터베이스를 복사할 수 없음: {0}\",\"the_database_cannot_be_finished\":\"데이터베이스를 마무리할 수 없음: {0}\",\"the_database_keeps_plant_the\":\"데이터베이스의 플랜트는 {0}, 백업의 플랜트는 {1}\",\"the_database_keeps_plant_not\":\"데이터베이스의 플랜트가 {1}이(가) 아니라 {0}\",\"the_backup_cannot_be_prepared\":\"{0}에 백업을 준비할 수 없음: {1}\",\"the_backup_cannot_be_put\":\"백업을 되돌릴 수 없음: {0}\",\"cannot_be_copied\":\"{0} 복사 불가: {1}\",\"see_that_the_disk_has\":\"디스크 여유 공간을 확인하세요.\",\"keeps_no_plant\":\"{0}에 플랜트 없음\",\"exists_already\":\"{0} 이미 있음\",\"a_backup_does_not_replace\":\"백업은 다른 백업을 덮어쓰지 않습니다. 새 이름을 쓰세요.\",\"see_that_the_directory_exists\":\"디렉터리가 있는지, 쓰기 권한이 있는지, 디스크 여유가 있는지 확인하세요.\",\"cannot_be_written\":\"{0}에 쓸 수 없음: {1}\",\"another_program_has_the_database\":\"다른 프로그램이 데이터베이스를 열고 있음\",\"close_it_then_try_again\":\"그 프로그램을 닫고 다시 시도하세요.\",\"is_not_the_url_of\":\"{0}은(는) 데이터베이스 URL이 아님\",\"is_not_a_database_that\":\"{0}: Hoistway가 지원하지 않는 데이터베이스\",\"make_room_on_the_disk\":\"디스크 공간을 확보하세요.\",\"give_this_user_the_right\":\"이 사용자에게 파일과 디렉터리의 쓰기 권한을 주세요.\",\"see_that_the_directory_exists_2\":\"디렉터리가 있는지, 쓰기 권한이 있는지 확인하세요.\",\"the_file_is_damaged_put\":\"파일 손상됨: hoistway db restore로 백업을 되돌리세요.\",\"name_another_file_or_remove\":\"다른 파일을 지정하거나, 필요 없는 파일이면 지우세요.\",\"another_program_is_writing_to\":\"다른 프로그램이 파일에 쓰는 중입니다. 그 프로그램을 닫으세요.\",\"see_that_the_database_server\":\"데이터베이스 서버가 동작하고 연결되는지 확인하세요.\",\"restart_it_it_then_finds\":\"다시 시작하세요. 명령을 보내기 전에 그사이 일어난 일을 먼저 확인합니다.\",\"cannot_open\":\"{0}을(를) 열 수 없음: {1}\",\"is_held_by_a_controller\":\"{0}: 이름 없는 제어기가 점유 중\",\"was_removed_another_controller_may\":\"{0} 삭제됨: 다른 제어기가 플랜트를 맡았을 수 있음\",\"was_removed_another_controller_may_2\":\"{0} 삭제됨: 다른 제어기가 플랜트를 맡았을 수 있음. 다시 시작하면 그사이 일어난 일을 먼저 확인합니다.\",\"this_controller_was_stopped_or\":\"이 제어기가 {0}초 넘게 멈췄거나 데이터베이스와 끊겨 플랜트 점유권이 만료됨\",\"this_controller_was_stopped_or_2\":\"이 제어기가 {0}초 넘게 멈췄거나 데이터베이스와 끊겨 플랜트 점유권이 만료됨. 다시 시작하면 그사이 일어난 일을 먼저 확인합니다.\",\"plant_is_held_by_since\":\"플랜트 {0}: {2}부터 {1}이(가) 점유 중\",\"stop_that_controller_first_or\":\"먼저 그 제어기를 멈추거나 이 제어기에 별도의 데이터베이스를 주세요.\",\"what_is_kept_cannot_be\":\"보관된 내용을 읽을 수 없음: {0}\",\"the_ledger_is_not_loaded\":\"원장을 아직 읽지 않음: 추가하기 전에 보관된 내용을 알아야 함\",\"old_events_cannot_be_deleted\":\"오래된 이벤트를 지울 수 없음: {0}\",\"give_each_plant_a_database\":\"플랜트마다 별도의 데이터베이스를 쓰거나 플랜트 파일에 이전 이름을 적으세요.\",\"the_records_cannot_be_kept\":\"기록을 저장할 수 없음: {0}\",\"another_controller_has_started_on\":\"플랜트 {0}의 데이터베이스로 다른 제어기가 시작됨\",\"stop_one_of_them_this\":\"둘 중 하나를 멈추세요. 이 제어기는 더 이상 명령을 보내지 않습니다.\",\"another_controller_has_started_on_2\":\"플랜트 {0}의 데이터베이스로 다른 제어기가 시작됨. 둘 중 하나를 멈추세요. 이 제어기는 더 이상 명령을 보내지 않습니다.\",\"the_playback_store_cannot_be\":\"재생 저장소를 열 수 없음: {0}\",\"the_playback_store_cannot_be_2\":\"재생 저장소를 읽을 수 없음: {0}\",\"playback_cannot_be_kept\":\"재생 기록을 저장할 수 없음: {0}\",\"old_playback_cannot_be_deleted\":\"오래된 재생 기록을 지울 수 없음: {0}\",\"there_is_no_row\":\"{0}행 없음\",\"the_version_of_the_database\":\"데이터베이스 버전을 읽을 수 없음: {0}\",\"the_database_is_in_use\":\"데이터베이스가 다른 용도로 쓰임: {0} 테이블이 있고 버전 없음\",\"give_hoistway_a_database_postgresql\":\"Hoistway 전용 데이터베이스(PostgreSQL은 스키마도 가능)를 쓰세요.\",\"the_database_has_schema_written\":\"데이터베이스 스키마 {0}은(는) 더 새로운 Hoistway가 씀. 이 버전은 {1}까지 지원\",\"run_the_newer_hoistway_or\":\"더 새로운 Hoistway를 쓰거나, 그 첫 시작 이전의 백업을 되돌리세요.\",\"the_tables_of_the_database\":\"데이터베이스 테이블을 만들 수 없음: {0}\",\"start_the_controller_on_it\":\"그 데이터베이스로 제어기를 한 번 시작하세요.\",\"a_record_cannot_be_kept\":\"기록을 저장할 수 없음: {0}: {1}\",\"the_versions_of_the_plant\":\"플랜트 버전을 읽을 수 없음: {0}\",\"the_versions_of_the_plant_2\":\"플랜트 버전을 저장할 수 없음: {0}\",\"another_controller_has_begun_on\":\"그사이 다른 제어기가 이 데이터베이스로 시작됨\",\"version_is_the_active_one\":\"버전 {0}은(는) 이미 운영 중입니다.\",\"stage_its_text_again_if\":\"다시 필요하면 그 파일을 새로 올리세요.\",\"version_is_rejected\":\"버전 {0} 거부됨: {1}\",\"wait_for_it_or_post\":\"기다리거나 버전 {0}을(를) 거부하세요.\",\"version_is_to_become_active\":\"버전 {0}이(가) 이미 적용 대기 중입니다.\",\"only_what_is_staged_or\":\"준비됨 또는 적용 대기인 버전만 거부할 수 있습니다.\",\"version_is_active\":\"버전 {0}: 운영 중.\",\"version_is_former\":\"버전 {0}: 이전 버전.\",\"version_is_rejected_2\":\"버전 {0}: 거부됨.\",\"version_of_the_plant_is\":\"플랜트 버전 {0}의 적용 요청이 취소됨\",\"reject_what_nobody_wants_any\":\"필요 없는 버전을 거부하세요.\",\"versions_are_staged_already\":\"준비된 버전이 이미 {0}개 있습니다.\",\"that_is_the_active_version\":\"운영 중인 버전 {0}과(와) 내용이 똑같습니다.\",\"activate_that_one_post_api\":\"버전 {0}을(를) 적용하세요.\",\"that_is_version_staged_to\":\"버전 {0}(준비됨)과 내용이 똑같습니다.\",\"that_is_version_former_to\":\"버전 {0}(이전 버전)과 내용이 똑같습니다.\",\"from_1\":\"접속 주소 ::1\",\"from_2\":\"접속 주소 {0}:{1}:{2}:{3}\",\"that_is_version_awaited_to\":\"버전 {0}(적용 대기)와 내용이 똑같습니다.\",\"no_route_from_to_2\":\"{0}에서 {1}(으)로 가는 경로 없음: {2}\",\"shft_is_outside_of_2\":\"SHFT {0}: {3}의 {1}..{2} 범위 밖\",\"rota_is_outside_of_2\":\"ROTA {0}: {3}의 {1}..{2} 범위 밖\",\"lift_is_outside_of_2\":\"LIFT {0}: {3}의 {1}..{2} 범위 밖\",\"shft_for_is_outside_of_2\":\"{1}의 SHFT {0}: {4}의 {2}..{3} 범위 밖\",\"rota_for_is_outside_of_2\":\"{1}의 ROTA {0}: {4}의 {2}..{3} 범위 밖\",\"lift_for_is_outside_of_2\":\"{1}의 LIFT {0}: {4}의 {2}..{3} 범위 밖\",\"is_not_connected_3\":\"{0} 연결되지 않음\",\"line\":\"{0}행: {1}\",\"place_to_reason_purpose_traffic\":\"위치 {0}~{1}, 통행 폐쇄, 사유: {2}\",\"place_to_reason_purpose_traffic_2\":\"위치 {0}~{1}, 통행 폐쇄, 사유: {2}, {3}까지\",\"place_to_reason_purpose_work\":\"위치 {0}~{1}, 작업자 폐쇄, 사유: {2}\",\"place_zone_reason_purpose_traffic\":\"구역 {0}, 통행 폐쇄, 사유: {1}\",\"place_zone_reason_purpose_traffic_2\":\"구역 {0}, 통행 폐쇄, 사유: {1}, {2}까지\",\"place_zone_reason_purpose_work\":\"구역 {0}, 작업자 폐쇄, 사유: {1}\",\"is_held_by_for_plant\":\"{0}: {3}부터 {1}이(가) 플랜트 {2}(으)로 점유 중\",\"there_is_no_event_did\":\"이벤트 {0} 없음. {1}을(를) 뜻하셨습니까?\",\"no_route_from_to_to_2\":\"{0}에서 {1}(으)로 가는 경로 없음: {2}~{3} 폐쇄됨\",\"barcode_is_given_twice_the\":\"바코드 {0} 중복: 처음은 {1}행\",\"keep_one\":\"하나만 남기세요\",\"barcode_is_not_1_to\":\"바코드 {0}: 보이는 ASCII 1~16자가 아님\",\"is_a_range_so_it\":\"{0}은(는) 범위이므로 양 끝이 필요함\",\"write_from_x_y_to\":\"{from: [x, y], to: [x, y]}로 쓰세요\",\"is_one_barcode_so_it\":\"{0}은(는) 바코드 하나이므로 위치도 하나임\",\"write_x_y_or_a\":\"[x, y]로 쓰거나 키를 범위로 쓰세요\",\"is_no_range_of_barcodes\":\"{0}은(는) 바코드 범위가 아님: 1001..1020 또는 A01..A20처럼 쓰세요\",\"the_ends_of_have_different\":\"{0}: 양 끝의 자릿수가 다름\",\"has_more_than_barcodes\":\"{0}: 바코드가 {1}개보다 많음\",\"is_no_address_write_host\":\"{0}은(는) 주소가 아님: 10.0.0.17:9000처럼 HOST:PORT로 쓰세요\",\"is_no_address_write_host_2\":\"'{0}'은(는) 주소가 아님: 10.0.0.17:9000처럼 HOST:PORT로 쓰세요\",\"port_is_outside_1_65535\":\"포트 {0}이(가) 1..65535를 벗어남\",\"track_through_alone_leads_nowhere\":\"{0}만 지나는 트랙은 이어지는 곳이 없음\",\"name_at_least_two_barcodes\":\"바코드를 두 개 이상 쓰세요\",\"track_leads_from_to_itself\":\"트랙이 {0}에서 자기 자신으로 이어짐\",\"name_it_once\":\"한 번만 쓰세요\",\"track_is_given_twice_the\":\"트랙 {0} → {1} 중복: 처음은 {2}행\",\"track_has_length_0_both\":\"트랙 {0} → {1} 길이 0: 둘 다 [{2}, {3}]에 있음\",\"move_one\":\"하나를 옮기세요\",\"track_is_mm_long_but\":\"트랙 {0} → {1} 길이는 {2} mm이나 양 끝 간격은 {3} mm\",\"correct_the_length_or_the\":\"길이나 위치를 고치세요\",\"correct_it_or_mark_it\":\"고치거나 curve: true로 표시하세요\",\"does_not_fit_the_vehicle\":\"{0}이(가) 차량 표시창에 맞지 않음: ASCII {1}자까지\",\"does_not_fit_the_vehicle_2\":\"'{0}'이(가) 차량 표시창에 맞지 않음: ASCII {1}자까지\",\"give_a_shorter_name_with\":\"display:에 더 짧은 이름을 쓰세요\",\"cannot_be_its_own_fallback\":\"{0}은(는) 자신의 대체 스테이션이 될 수 없음\",\"is_no_port_a_vehicle\":\"{0}은(는) 포트가 아님: 차량이 그곳의 위치를 알고 있어 dest를 쓰지 않음\",\"leave_it_out_2\":\"빼세요\",\"give_it_under_buffers\":\"buffers 아래에 쓰세요\",\"unknown_buffer\":\"알 수 없는 버퍼 {0}\",\"has_the_same_buffer_as\":\"{0}의 버퍼가 {1}과(와) 같음: {2}\",\"each_needs_its_own\":\"각각 따로 있어야 합니다\",\"zone_is_soft_and_no\":\"구역 {0}에 soft와 no_stop이 함께 있음\",\"leave_out_one_of_them\":\"둘 중 하나를 빼세요\",\"zone_has_a_share_or\":\"구역 {0}에 share 또는 patience가 있으나 soft가 아니어서 효력이 없음\",\"add_soft_true\":\"soft: true를 추가하세요\",\"carrier_does_not_fit_the\":\"캐리어 {0}이(가) 차량 표시창에 맞지 않음: {1}자까지\",\"holds_already_one_carrier_a\":\"{0}에 이미 {1}이(가) 있음: 스테이션마다 캐리어 하나\",\"choose_another\":\"다른 것을 고르세요\",\"has_no_port\":\"{0}에 포트 번호 없음\",\"write_host_port\":\"HOST:PORT로 쓰세요\",\"is_no_code_from_0\":\"{0}은(는) 0~65535(0xFFFF)의 코드가 아님\",\"is_no_code_from_0_2\":\"'{0}'은(는) 0~65535(0xFFFF)의 코드가 아님\",\"code_is_given_twice\":\"코드 {0} 중복\",\"the_catalogue\":\"카탈로그\",\"the_plant_file\":\"플랜트 파일\",\"and_are_both_called\":\"{0}과(와) {1}의 이름이 둘 다 {2}\",\"people_will_take_one_for\":\"사람이 서로 혼동할 수 있습니다\",\"is_no_parameter_number\":\"{0}은(는) 파라미터 번호가 아님\",\"is_no_parameter_number_2\":\"'{0}'은(는) 파라미터 번호가 아님\",\"write_two_hexadecimal_digits_in\":\"\\\"1C\\\"처럼 16진수 두 자리를 따옴표로 감싸 쓰세요\",\"the_scale_of_is_not\":\"{0}의 scale이 0보다 크지 않음\",\"it_is_what_one_raw\":\"원시값 한 단계의 크기입니다\",\"min_of_is_above_its\":\"{1}의 min {0}이(가) max {2}보다 큼\",\"swap_them\":\"서로 바꾸세요\",\"the_default_of_is_not\":\"{0}의 default가 {1}~{2} 밖에 있음\",\"is_read_only_so_it\":\"{0}은(는) 읽기 전용이라 운전 중에 쓰지 않음\",\"min_lies_between_two_steps\":\"min {0}이(가) {1} 단위의 두 단계 사이에 있음\",\"max_lies_between_two_steps\":\"max {0}이(가) {1} 단위의 두 단계 사이에 있음\",\"default_lies_between_two_steps\":\"default {0}이(가) {1} 단위의 두 단계 사이에 있음\",\"write_or_another_scale\":\"{0}(으)로 쓰거나 scale을 바꾸세요\",\"is_on_the_wire_which\":\"{0} {1}은(는) 회선에서 {2}이(가) 됨: 0~{3}만 실림\",\"check_the_value_and_the\":\"값과 scale을 확인하세요\",\"choice_is_no_raw_value\":\"선택지 {0}은(는) {1}~{2}의 원시값이 아님\",\"choices_are_named_by_raw\":\"선택지는 원시값으로 이름을 붙입니다\",\"the_plant_has_no_vehicle\":\"플랜트에 차량 없음\",\"give_at_least_one_under\":\"vehicles 아래에 하나 이상 쓰세요\",\"the_plant_has_no_station\":\"플랜트에 스테이션 없음\",\"give_at_least_two_under\":\"stations 아래에 둘 이상 쓰세요\",\"numbers_up_to_without_leading\":\"앞자리 0 없이 {0}까지의 숫자\",\"at_most_characters\":\"{0}자까지\",\"barcode_does_not_fit_dialect\":\"바코드 {0}이(가) {2}의 프로토콜 변형 {1}에 맞지 않음: 가능한 것은 {3}\",\"barcode_and_more_do_not\":\"바코드 {0} 외 {1}개가 {3}의 프로토콜 변형 {2}에 맞지 않음: 가능한 것은 {4}\",\"correct_the_barcode_or_the\":\"바코드나 차량의 프로토콜 변형을 고치세요\",\"barcode_is_no_tag_that\":\"바코드 {0}은(는) AGV가 읽는 태그가 아님: 인쇄 가능한 ASCII 4자\",\"barcode_and_more_are_no\":\"바코드 {0} 외 {1}개는 AGV가 읽는 태그가 아님: 인쇄 가능한 ASCII 4자\",\"write_it_as_four_digits\":\"0042처럼 네 자리 숫자로 쓰세요\",\"track_is_mm_long_can\":\"트랙 {0} → {1} 길이 {2} mm: {3}에 알릴 수 있는 값은 {4}까지\",\"put_a_barcode_between_dist\":\"중간에 바코드를 두세요 (DIST_NEXT는 16비트)\",\"s_dev_id_is_0\":\"{0}의 dev_id가 0: 번호 없는 차량이 보내는 값\",\"number_vehicles_from_1\":\"차량 번호는 1부터 매기세요\",\"limits_to\":\"{0} ({1}, 한계 {2}~{3})\",\"limits_to_and_more\":\"{0} ({1}, 한계 {2}~{3}) 외 {4}대\",\"s_target_is_beyond_the\":\"{0}의 {1} 목표가 한계를 벗어남: {2}\",\"correct_dest_or_the_vehicle\":\"dest 또는 차량의 limits나 offset을 고치세요\",\"there_are_parking_places_for\":\"운행 차량 {1}대에 주차 위치 {0}곳\",\"add_barcodes_to_parking_best\":\"parking에 바코드를 추가하세요. 경로가 지나지 않는 곳이 좋습니다\",\"starts_at_which_at_covers\":\"{0}의 시작 위치 {1}을(를) {3}의 {2}이(가) 덮음 (길이 {4} mm)\",\"start_one_of_them_elsewhere\":\"둘 중 하나의 시작 위치를 바꾸세요\",\"starts_mm_from_the_plant\":\"{0}의 시작 위치가 {2}에서 {1} mm: 플랜트의 이격 거리는 {3} mm\",\"vehicles_start_in_zone_which\":\"수용 대수 {2}인 구역 {1}에서 차량 {0}대가 시작함\",\"start_some_of_them_elsewhere\":\"일부의 시작 위치를 바꾸세요\",\"starts_in_zone_where_no\":\"{0}의 시작 위치가 정지 금지 구역 {1}에 있음\",\"start_it_elsewhere\":\"시작 위치를 바꾸세요\",\"is_a_parking_place_in\":\"주차 위치 {0}이(가) 정지 금지 구역 {1}에 있음\",\"take_it_out_of_one\":\"둘 중 하나에서 빼세요\",\"the_track_falls_into_pieces\":\"스테이션이 있는 트랙이 {0}조각으로 나뉨: {1}이(가) {2}과(와) 이어지지 않음\",\"no_transfer_is_possible_from\":\"서로 간에 반송할 수 없습니다\",\"no_track_touches_barcode\":\"바코드 {0}에 닿는 트랙 없음\",\"name_it_under_track_or\":\"track에 쓰거나 빼세요\",\"dead_end_track_leads_to\":\"막다른 길: {0}(으)로 가는 트랙은 있으나 나가는 트랙 없음\",\"add_track_from_it_or\":\"나가는 트랙을 추가하거나 그 앞에서 트랙을 끝내세요\",\"no_track_leads_to_a\":\"{0}(으)로 가는 트랙 없음: 나갈 수는 있으나 돌아올 수 없음\",\"add_track_to_it\":\"그곳으로 가는 트랙을 추가하세요\",\"starts_at_on_a_piece\":\"{0}의 시작 위치 {1}이(가) 스테이션 없는 트랙에 있음\",\"start_it_on_track_that\":\"스테이션이 있는 트랙에서 시작하게 하세요\",\"is_the_only_station_on\":\"그 트랙 조각의 스테이션이 {0}뿐임: 반송을 시작하거나 끝낼 수 없음\",\"connect_it_to_other_stations\":\"다른 스테이션과 이으세요\",\"starts_at_from_where_no\":\"{0}의 시작 위치 {1}에서 스테이션 {2}(으)로 가는 길 없음\",\"start_it_elsewhere_or_add\":\"시작 위치를 바꾸거나 빠진 트랙을 추가하세요\",\"check_the_direction_of_the\":\"주변 트랙의 방향을 확인하세요\",\"at_cannot_be_reached_from\":\"{2}에서 {1}의 {0}에 갈 수 없음\",\"at_has_no_way_to\":\"{1}의 {0}에서 {2}(으)로 가는 길 없음\",\"track_leads_into_the_loop\":\"{0} 외 바코드 {1}개의 고리로 들어가는 트랙은 있으나 나가는 트랙 없음\",\"add_track_out_of_it\":\"나가는 트랙을 추가하세요\",\"the_plant_file_has_no\":\"플랜트 파일에 {0} 없음\",\"the_catalogue_has_no\":\"카탈로그에 {0} 없음\",\"has_no_at\":\"{0}에 at 없음\",\"has_no_link\":\"{0}에 link 없음\",\"has_no_number\":\"{0}에 number 없음\",\"has_no_through\":\"{0}에 through 없음\",\"has_no_id\":\"{0}에 id 없음\",\"has_no_lift\":\"{0}에 lift 없음\",\"has_no_rota\":\"{0}에 rota 없음\",\"has_no_shft\":\"{0}에 shft 없음\",\"has_no_protocol\":\"{0}에 protocol 없음\",\"has_no_max\":\"{0}에 max 없음\",\"has_no_min\":\"{0}에 min 없음\",\"has_no_name\":\"{0}에 name 없음\",\"has_no_device\":\"{0}에 device 없음\",\"has_no_kind\":\"{0}에 kind 없음\",\"has_no_from\":\"{0}에 from 없음\",\"has_no_to\":\"{0}에 to 없음\",\"has_no_dev_id\":\"{0}에 dev_id 없음\",\"has_no_barcodes\":\"{0}에 barcodes 없음\",\"add\":\"{0}을(를) 추가하세요: {1}\",\"known_here\":\"여기서 쓸 수 있는 것: {0}\",\"unknown_key\":\"알 수 없는 키 {0}\",\"unknown_key_in\":\"{1}에 알 수 없는 키 {0}\",\"give_at_least\":\"{0}개 이상 쓰세요\",\"expected_got\":\"{0}: 필요한 것은 {1}, 있는 것은 {2}\",\"expected_got_nothing\":\"{0}: 필요한 것은 {1}, 값이 없음\",\"expected_text_got\":\"{0}: 필요한 것은 텍스트, 있는 것은 {1}\",\"expected_text_got_nothing\":\"{0}: 필요한 것은 텍스트, 값이 없음\",\"the_plant_file_expected_got\":\"플랜트 파일: 필요한 것은 {0}, 있는 것은 {1}\",\"the_plant_file_expected_got_2\":\"플랜트 파일: 필요한 것은 {0}, 값이 없음\",\"the_catalogue_expected_got\":\"카탈로그: 필요한 것은 {0}, 있는 것은 {1}\",\"the_catalogue_expected_got_nothing\":\"카탈로그: 필요한 것은 {0}, 값이 없음\",\"write_it_in_quotes\":\"따옴표로 감싸세요\",\"write_the_number_alone_a\":\"숫자만 쓰세요: {0} 단위 정수\",\"true_or_false\":\"true 또는 false\",\"a_whole_number\":\"정수\",\"a_whole_number_from_to\":\"{0}~{1}의 정수\",\"a_whole_number_of_from\":\"{1}~{2}의 정수({0})\",\"a_whole_number_of_path\":\"{0}~{1}의 정수(경로 요소)\",\"a_whole_number_of_transfers\":\"{0}~{1}의 정수(반송)\",\"a_whole_number_of_vehicles\":\"{0}~{1}의 정수(차량)\",\"a_whole_number_of_pulses\":\"{0}~{1}의 정수(펄스)\",\"a_whole_number_of_percent\":\"{0}~{1}의 정수(%)\",\"a_whole_number_of_bits\":\"{0}~{1}의 정수(비트)\",\"a_number_from_to\":\"{0}~{1}의 숫자\",\"a_whole_number_or_text\":\"정수 또는 텍스트\",\"a_whole_number_or_text_2\":\"[정수 또는 텍스트, 정수 또는 텍스트]\",\"a_whole_number_of_from_2\":\"[{1}~{2}의 정수({0}), {4}~{5}의 정수({3})]\",\"a_whole_number_of_from_3\":\"[{1}~{2}의 정수({0}), {4}~{5}의 정수({3})] 또는 매핑\",\"hoist_or_agv\":\"hoist 또는 agv\",\"itsc_or_enig_or_hi\":\"itsc, enig, hi 중 하나\",\"leave_or_open_or_close\":\"leave, open, close 중 하나\",\"none_or_even_or_odd\":\"none, even, odd 중 하나\",\"port_or_sbfl_or_sbfr\":\"port, sbfl, sbfr, agv_buffer 중 하나\",\"a_number\":\"숫자\",\"a_list\":\"목록\",\"a_list_of\":\"{0}개짜리 목록\",\"a_mapping\":\"매핑\",\"text\":\"텍스트 '{0}'\",\"unknown_dialect\":\"알 수 없는 프로토콜 변형 {0}\",\"is_the_name_of_a\":\"{0}은(는) 기본 제공 변형의 이름임\",\"choose_another_name_for_your\":\"프로토콜 변형에 다른 이름을 쓰세요\",\"unknown_preset\":\"알 수 없는 기본 제공 변형 {0}\",\"presets\":\"기본 제공 변형: {0}\",\"dialect\":\"프로토콜 변형 {0}: {1}\",\"unknown_dialect_field\":\"프로토콜 변형에 알 수 없는 항목 {0}\",\"unknown_crc\":\"알 수 없는 crc {0}\",\"unknown_crc_parameter\":\"알 수 없는 crc 파라미터 {0}\",\"unknown_itsc_dialect\":\"알 수 없는 iTSC 프로토콜 변형 {0}\",\"unknown_enig_dialect\":\"알 수 없는 ENIG 프로토콜 변형 {0}\",\"unknown_hi_dialect\":\"알 수 없는 HI 프로토콜 변형 {0}\",\"is_none_of_3\":\"{0} '{1}'은(는) 다음 중 하나가 아님: {2}\",\"barcode_bytes_is_none_of\":\"barcode_bytes {0}은(는) 다음 중 하나가 아님: {1}\",\"value_digits_is_none_of\":\"value_digits {0}은(는) 다음 중 하나가 아님: {1}\",\"pad_is_none_of\":\"pad {0}은(는) 다음 중 하나가 아님: {1}\",\"crc_covers_type_is_none\":\"crc_covers_type {0}은(는) 다음 중 하나가 아님: {1}\",\"ack_answers_is_none_of\":\"ack_answers {0}은(는) 다음 중 하나가 아님: {1}\",\"crc_is_no_name\":\"crc {0}은(는) 이름이 아님\",\"crc_width_itsc_s_crc\":\"crc width {0}: iTSC의 CRC 필드는 16비트임\",\"max_sub_is_no_number\":\"max_sub {0}은(는) 1~16777215의 바이트 수가 아님\",\"max_len_is_no_number\":\"max_len {0}은(는) 1~255의 바이트 수가 아님\",\"is_no_command_code_from\":\"{0} {1}은(는) 0x0000~0xFFFF의 명령 코드가 아님\",\"and_are_both_0x\":\"{0}과(와) {1}이(가) 둘 다 0x{2}\",\"host_id_acs_needs_target\":\"host_id acs에는 target include가 필요함: 그 밖에 장치를 가리키는 것이 없음\",\"alias_is_no_text_of\":\"별칭 {0}은(는) 인쇄 가능한 ASCII 텍스트가 아님\",\"is_no_devicetype_from_1\":\"{0} {1}은(는) 1~255의 DeviceType이 아님\",\"is_given_to_already\":\"{0} {1}은(는) 이미 {2}에 있음\",\"cannot_be_a_target_which\":\"{0} {1}은(는) Target이 될 수 없음(0x20 미만만 가능): target omit을 쓰세요\",\"its_dest_counts_only_where\":\"dest는 데이터베이스를 만들 때만 쓰임: 티칭하거나 PUT /api/v1/stations/ID/dest\",\"its_dest_counts_only_where_2\":\"{0}; dest는 데이터베이스를 만들 때만 쓰임: 티칭하거나 PUT /api/v1/stations/ID/dest\",\"job_stands_in_the_way\":\"작업 {0} 때문에 불가: {1}\",\"job_stands_in_the_way_2\":\"작업 {0} 때문에 불가: {1} (외 {2}건)\",\"carrier_stands_in_the_way\":\"캐리어 {0} 때문에 불가: {1}\",\"carrier_stands_in_the_way_2\":\"캐리어 {0} 때문에 불가: {1} (외 {2}건)\",\"vehicle_stands_in_the_way\":\"차량 {0} 때문에 불가: {1}\",\"vehicle_stands_in_the_way_2\":\"차량 {0} 때문에 불가: {1} (외 {2}건)\",\"station_stands_in_the_way\":\"스테이션 {0} 때문에 불가: {1}\",\"station_stands_in_the_way_2\":\"스테이션 {0} 때문에 불가: {1} (외 {2}건)\",\"closure_stands_in_the_way\":\"폐쇄 {0} 때문에 불가: {1}\",\"closure_stands_in_the_way_2\":\"폐쇄 {0} 때문에 불가: {1} (외 {2}건)\",\"operation_stands_in_the_way\":\"드라이브 작업 {0} 때문에 불가: {1}\",\"operation_stands_in_the_way_2\":\"드라이브 작업 {0} 때문에 불가: {1} (외 {2}건)\",\"device_stands_in_the_way\":\"장치 {0} 때문에 불가: {1}\",\"device_stands_in_the_way_2\":\"장치 {0} 때문에 불가: {1} (외 {2}건)\",\"teaching_session_stands_in_the\":\"티칭 세션 {0} 때문에 불가: {1}\",\"teaching_session_stands_in_the_2\":\"티칭 세션 {0} 때문에 불가: {1} (외 {2}건)\",\"plant_listen_stands_in_the\":\"플랜트의 listen 때문에 불가: {0}\",\"plant_listen_stands_in_the_2\":\"플랜트의 listen 때문에 불가: {0} (외 {1}건)\",\"is_now_at_the_same\":\"같은 위치에서 이름이 {0}(으)로 바뀜\",\"was_at\":\"이전 위치 [{0}, {1}]\",\"at\":\"위치 [{0}, {1}]\",\"by_mm_from_to\":\"{0} mm 이동: [{1}, {2}] → [{3}, {4}]\",\"is_a_parking_place_now\":\"주차 위치가 됨\",\"is_no_parking_place_any\":\"더 이상 주차 위치가 아님\",\"was_mm_long\":\"이전 길이 {0} mm\",\"mm_long\":\"길이 {0} mm\",\"describes_parameter_in_another_way\":\"파라미터 {0}의 설명이 다름\",\"describes_parameters_in_another_way\":\"파라미터 {0}의 설명이 다름\",\"describes_parameters_and_more_in\":\"파라미터 {0} 외 {1}개의 설명이 다름\",\"has_another_description\":\"설명이 다름\",\"a_vehicle_that_stands_there\":\"그곳에 있거나 점유하거나 그곳으로 가는 차량은 새 플랜트에서 위치가 없어짐\",\"change_over_with_no_vehicle\":\"그곳에 차량이 없을 때 바꾸세요\",\"jobs_that_it_carries_out\":\"수행 중인 작업, 티칭한 OFFSET, 이력에 해당하는 차량이 없어짐\",\"let_it_end_its_job\":\"작업을 끝내게 하고 레일에서 내리세요\",\"it_has_another_number_or\":\"번호나 종류가 바뀜: {0} {1} → {2} {3}\",\"is_it_the_same_machine\":\"같은 기계인지 확인하세요. OFFSET은 유지됩니다\",\"jobs_from_and_to_it\":\"출발지·도착지로 쓰는 작업, 놓인 캐리어, 티칭한 DEST, 예약이 없는 스테이션을 가리키게 됨\",\"end_those_jobs_move_the\":\"그 작업을 끝내고 캐리어를 옮기거나 이름을 유지하세요\",\"it_was_a_and_is\":\"{0}에서 {1}(으)로 바뀜: 다른 차량이나 다른 명령으로 처리됨\",\"end_its_jobs_first\":\"먼저 그 작업들을 끝내세요\",\"it_is_served_from_instead\":\"{1} 대신 {0}에서 처리됨: 티칭한 DEST는 이전 위치에서 잰 값\",\"teach_it_anew_before_jobs\":\"작업을 보내기 전에 다시 티칭하세요\",\"no_way_leads_there_and\":\"대부분의 스테이션이 있는 곳에서 오가는 길이 없어짐: 작업이 끝없이 대기하게 됨\",\"add_the_missing_track\":\"빠진 트랙을 추가하세요\",\"export_it_first_get_api\":\"먼저 내보내고(GET /api/v1/teaching/{0}), 같은 장소나 기계이면 이름을 유지하세요\",\"its_taught_dest_version_serves\":\"티칭한 DEST(버전 {0})를 쓸 곳이 없어짐\",\"its_taught_offset_version_serves\":\"티칭한 OFFSET(버전 {0})을 쓸 차량이 없어짐\",\"its_in_the_plant_file_does\":\"플랜트 파일의 {0}은(는) 쓰이지 않음({1}): 데이터베이스의 버전 {2}이(가) 유효함, {3}, {4} ({5})\",\"to_take_the_files_put\":\"파일의 값을 쓰려면: PUT /api/v1/{0}s/{1}/{2} {3}\",\"what_was_noted_of_it\":\"기록된 내용이 없어짐 ({0})\",\"the_values_that_were_read\":\"읽어 둔 값이 더 이상 표시되지 않음\",\"back_it_up_first_post\":\"먼저 백업하세요: POST /api/v1/drives/ID/backups\",\"end_it_or_cancel_it\":\"먼저 끝내거나 취소하세요\",\"vehicles_are_to_connect_to\":\"차량이 접속할 {0}:{1}에서 제어기가 접속을 받지 않음\",\"stop_the_controller_and_start\":\"제어기를 멈추고 새 파일로 시작하세요\",\"it_names_which_the_new\":\"새 플랜트에 없는 {0}을(를) 사용함\",\"it_names_which_the_new_2\":\"새 플랜트에 없는 {0}을(를) 사용함.\",\"cannot_be_reached_from_the\":\"새 플랜트에서 다른 스테이션으로부터 {0}에 갈 수 없음\",\"it_is_s_which_the\":\"새 플랜트에 없는 {0}의 작업임\",\"it_is_at_which_the\":\"새 플랜트에 없는 {0}에 있음\",\"tell_where_it_is_put\":\"위치를 기록하세요: PUT /api/v1/carriers/ID\",\"it_may_be_on_the\":\"레일에 있을 수 있으나 새 플랜트에 없음\",\"take_it_off_the_rail\":\"레일에서 내리고 기록하세요: POST /api/v1/vehicles/{0}/release, verdict off_rail\",\"it_stands_at_holds_or\":\"새 플랜트에 없는 {0}에 있거나 점유하거나 그곳으로 주행 중\",\"move_it_elsewhere_first\":\"먼저 다른 곳으로 옮기세요\",\"it_drives_from_to_where\":\"새 플랜트에 트랙이 없는 {0}~{1}을(를) 주행 중\",\"let_it_end_its_way\":\"먼저 주행을 끝내게 하세요\",\"it_names_a_station_or\":\"새 플랜트에 없는 스테이션이나 차량을 사용함\",\"close_it_first\":\"먼저 닫으세요\",\"its_dest_was_taught_at\":\"DEST는 {0}에서 티칭했으나 {1}에서 처리됨: 호이스트가 다른 곳에 닿게 됨\",\"patch_api_v1_stations_with\":\"먼저 PATCH /api/v1/stations/{0}에 out_of_service를 보내고, 이후 다시 티칭하세요\",\"is_closed_and_of_it\":\"{0} 폐쇄됨 ({1}), 그중 {2}이(가) 새 플랜트에 없음\",\"to_is_closed_and_of\":\"{0}~{1} 폐쇄됨 ({2}), 그중 {3}이(가) 새 플랜트에 없음\",\"its_owner_opens_it_first\":\"먼저 폐쇄한 사람이 해제해야 합니다\",\"it_is_under_way_at\":\"새 플랜트에 없는 {0}에서 진행 중\",\"somebody_works_at_it_lockout\":\"작업자가 정비 잠금한 것인데 새 플랜트에 없음\",\"its_owner_lifts_the_lockout\":\"먼저 잠근 사람이 정비 잠금을 해제해야 합니다\",\"write_yaml_plants_small_yaml\":\"YAML로 쓰세요. 예: plants/small.yaml\",\"this_is_no_yaml\":\"YAML이 아님: {0}\",\"the_file_is_empty\":\"파일이 비어 있음\",\"a_second_document_starts_here\":\"여기서 두 번째 문서가 시작됨\",\"one_file_holds_one_plant\":\"파일 하나에 플랜트 하나만 쓰세요\",\"an_alias_cannot_be_used\":\"여기에 별칭(*{0})을 쓸 수 없음\",\"write_the_value_again\":\"값을 다시 쓰세요\",\"this_is_nested_more_than\":\"{0}단계보다 깊게 중첩됨\",\"a_tag_cannot_be_used\":\"여기에 태그({0})를 쓸 수 없음\",\"the_file_has_more_than_2\":\"파일의 값이 {0}개보다 많음\",\"write_barcodes_as_ranges\":\"바코드를 범위로 쓰세요\",\"a_text_is_longer_than\":\"텍스트가 {0}자보다 김\",\"shorten_it\":\"줄이세요\",\"has_a_character_that_cannot\":\"{0}: 표시할 수 없는 문자가 있음\",\"has_a_character_that_cannot_2\":\"'{0}': 표시할 수 없는 문자가 있음\",\"a_key_must_be_text\":\"키는 텍스트나 숫자여야 함\",\"quote_it_if_it_begins\":\"[ { * & 로 시작하면 따옴표로 감싸세요\",\"is_given_twice_the_first\":\"{0} 중복: 처음은 {1}행\",\"is_no_number_of_a\":\"{0}: {1}은(는) 여기서 버퍼 번호가 아님\",\"is_no_number_of_a_2\":\"{0}: {1}은(는) 여기서 도어 번호가 아님\",\"is_no_number_of_an\":\"{0}: {1}은(는) 여기서 AGV 번호가 아님\",\"is_no_number_of_here\":\"{0}: {1}은(는) 여기서 {2} 번호가 아님\",\"has_the_same_number_on\":\"{0}의 {1} 번호가 {2}과(와) 같음: {3}\",\"give_it_under_links\":\"links 아래에 쓰세요\",\"unknown_link\":\"알 수 없는 링크 {0}\",\"link_speaks_this_needs\":\"링크 {0}의 프로토콜은 {1}, 필요한 것은 {2}\",\"name_another_link_or_correct\":\"다른 링크를 쓰거나 protocol을 고치세요\",\"is_reached_in_two_ways\":\"{0}의 연결 방법이 둘임\",\"is_reached_in_no_way\":\"{0}의 연결 방법이 없음\",\"give_address_host_port_or\":\"address: HOST:PORT 또는 serial: {device: ...}를 쓰세요\",\"is_reached_where_is\":\"{0}과(와) {1}의 연결 위치가 같음\",\"each_link_needs_its_own\":\"링크마다 따로 있어야 합니다\",\"an_itsc_line_carries_one\":\"{0}: iTSC 회선에는 호이스트 하나만 연결됨\",\"give_the_hoist_an_address\":\"vehicles 아래 호이스트에 address를 쓰세요\",\"known_preset\":\"쓸 수 있는 것: preset, {0}\",\"no_track_leads_between_and\":\"{2}이(가) 가로막는 {0}과(와) {1} 사이에 트랙 없음\",\"name_two_neighbours_on_the\":\"트랙에서 이웃한 두 바코드를 쓰세요\",\"no_station_has_buffer\":\"버퍼 {0}을(를) 쓰는 스테이션 없음\",\"name_it_at_the_station\":\"버퍼가 있는 스테이션에 쓰세요\",\"is_no_time_of_day\":\"{0}은(는) 시각 범위가 아님\",\"is_no_time_of_day_2\":\"'{0}'은(는) 시각 범위가 아님\",\"write_from_to_in_utc\":\"\\\"12:00-12:30\\\"처럼 UTC로 시작-끝을 쓰세요\",\"nothing_is_on_link\":\"링크 {0}에 연결된 것이 없음\",\"name_it_at_a_device\":\"장치에 이 링크를 쓰세요\",\"is_a_name_under_already\":\"{0}은(는) 이미 {1} 아래의 이름임\",\"choose_another_name_2\":\"다른 이름을 고르세요\",\"known_others_go_into_the\":\"쓸 수 있는 것: {0}. 그 밖의 것은 링크의 dialect에 쓰세요\",\"is_no_name_on_the\":\"{0}은(는) 회선의 별칭이 아님 (PROTOCOLS 3.2)\",\"has_the_same_alias_as\":\"{0}의 별칭이 {1}과(와) 같음: {2}\",\"is_a_at_on_the\":\"{0}은(는) AGV 트랙의 {2}에 있는 {1}임\",\"hoists_and_agvs_need_track\":\"호이스트와 AGV는 각자의 트랙이 필요합니다\",\"is_a_hoist_and_starts\":\"{0}은(는) 호이스트인데 AGV 트랙의 {1}에서 시작함\",\"idle_hoists_have_no_place\":\"유휴 호이스트가 주차할 곳 없음\",\"give_barcodes_of_their_track\":\"parking 아래에 그 트랙의 바코드를 쓰세요\",\"zone_is_soft_and_lies\":\"구역 {0}은(는) 완화 구역인데 효력이 없는 AGV 트랙에 있음\",\"give_it_a_capacity_instead\":\"대신 capacity를 쓰세요\",\"there_is_no_charger\":\"충전기 없음\",\"give_one_under_chargers\":\"chargers 아래에 하나를 쓰세요\",\"agvs_are_never_sent_to\":\"AGV를 충전하러 보내지 않음: 배터리 잔량을 보고하지 않음\",\"say_when_under_charging_trips\":\"charging 아래에 시기를 쓰세요: trips, after, windows\",\"unknown_barcode\":\"알 수 없는 바코드 {0}\",\"give_it_under_barcodes\":\"barcodes 아래에 쓰세요\",\"unknown_station\":\"알 수 없는 스테이션 {0}\",\"give_it_under_stations\":\"stations 아래에 쓰세요\",\"unknown_event\":\"알 수 없는 이벤트 {0}\",\"cannot_be_a_name_here\":\"{0}은(는) 여기서 이름이 될 수 없음\",\"cannot_be_a_name_here_2\":\"'{0}'은(는) 여기서 이름이 될 수 없음\",\"use_letters_digits_and_only\":\"영문자, 숫자, . _ - : + @ 만 64자까지, 영문자나 숫자로 시작하게 쓰세요\",\"letters_digits_and_only_at\":\"영문자, 숫자, . _ - : + @ 만 64자까지, 영문자나 숫자로 시작\",\"is_a_hoist_it_has\":\"{0}은(는) 호이스트: 전용 회선을 씀\",\"leave_link_out\":\"link를 빼세요\",\"is_a_reference_vehicle_its_3\":\"{0}은(는) 기준 차량: offset이 0이라 쓰인 값은 사용하지 않음\",\"s_curve_speed_is_more\":\"{0}의 curve_speed {1}이(가) max_speed {2}보다 큼\",\"both_are_in_mm_s\":\"둘 다 mm/s 단위입니다\",\"is_an_agv_is_a_2\":\"{0}은(는) AGV: {1}은(는) 호이스트 항목임\",\"is_an_agv_and_has_2\":\"{0}은(는) AGV인데 link 없음\",\"add_link_the_name_of\":\"link에 enig 링크 이름을 쓰세요\",\"connects_to_us_so_its\":\"{0}은(는) 제어기로 접속하므로 address에 포트가 없어야 함\",\"write_the_host_alone_or\":\"호스트만 쓰거나 listen을 빼세요\",\"connects_to_us_but_the\":\"{0}은(는) 제어기로 접속하나 플랜트가 접속을 받지 않음\",\"give_listen_host_port_at\":\"파일 맨 위에 listen: HOST:PORT를 쓰세요\",\"has_no_address_to_connect\":\"{0}에 접속할 주소 없음\",\"give_address_host_port_or_2\":\"address: HOST:PORT 또는 listen: true를 쓰세요\",\"has_the_same_dev_id\":\"{0}의 dev_id가 {1}과(와) 같음: {2}\",\"has_the_same_address_as\":\"{0}의 address가 {1}과(와) 같음: {2}\",\"has_the_same_start_as\":\"{0}의 start가 {1}과(와) 같음: {2}\",\"s_limits_are_upside_down\":\"{0}의 {1} 한계가 뒤바뀜: {2} > {3}\",\"s_max_count_is_more\":\"{0}의 max_count {1}이(가) 프로토콜 변형의 패킷 한도 {2}보다 큼\",\"lower_it_or_raise_max\":\"줄이거나 자체 프로토콜 변형에서 max_sub를 늘리세요\",\"km_of_track\":\"트랙 {0} km\",\"m_of_track\":\"트랙 {0} m\",\"side_buffer_left\":\"좌측 사이드 버퍼\",\"side_buffer_right\":\"우측 사이드 버퍼\",\"agv_buffer\":\"AGV 버퍼\",\"one_way_track\":\"일방통행 트랙\",\"two_way_track\":\"양방향 트랙\",\"vehicle_s_start\":\"차량 시작 위치\",\"two_way_kilometres\":\"양방향 트랙, km\",\"strongly_connected_parts\":\"서로 오갈 수 있는 부분\",\"buffers_for_fewer_than_two\":\"차량 두 대가 못 들어가는 구간\",\"barcodes_that_exclude_others\":\"다른 바코드를 막는 바코드\",\"shortest_edge_mm\":\"가장 짧은 구간, mm\",\"middle_edge_mm\":\"중간 구간, mm\",\"longest_edge_mm\":\"가장 긴 구간, mm\",\"mean_way_between_ports_m\":\"포트 간 평균 거리, m\",\"parking_places\":\"주차 위치\",\"agv_buffers\":\"AGV 버퍼\",\"side_buffers\":\"사이드 버퍼\",\"track_is_shorter_than_the\":\"트랙이 양 끝의 직선거리보다 짧음\",\"another_barcode_lies_within_mm\":\"{0} mm 안에 다른 바코드가 있으나 이어진 트랙 없음\",\"doubled_barcodes\":\"겹친 바코드\",\"are_both_on_the_rail\":\"둘 다 레일에 있는지, 하나가 옛 이름인지 확인하세요\",\"track_crosses_other_track_without\":\"공통 바코드 없이 트랙이 교차함: 차량이 서로 배제됨\",\"is_a_barcode_missing_or\":\"바코드가 빠졌는지, 한쪽이 위로 지나는지 확인하세요\",\"barcodes_of_other_branches_lie\":\"다른 갈래의 바코드가 이격 거리 {0} mm 안에 있음: 한 번에 한 대만 통과\",\"between_two_branches_there_is\":\"두 분기 사이에 길이 {0} mm 차량 두 대의 자리 없음: 그곳에서 대기하지 않음\",\"short_buffers\":\"짧은 대기 구간\",\"grants_pass_through_lay_barcodes\":\"허가가 통과함; 바코드를 더 촘촘히 두거나 분기를 띄우세요\",\"barcodes_are_nearer_to_each\":\"바코드 간격이 차량 길이({0} mm)보다 좁음: 한 대가 둘 이상을 덮음\",\"dense_barcodes\":\"촘촘한 바코드\",\"a_station_lies_at_a\":\"스테이션이 합류·분기점에 있음: 그곳에 서면 양쪽을 막음\",\"stations_at_branches\":\"분기점의 스테이션\",\"serve_it_from_a_barcode\":\"앞이나 뒤의 바코드에서 처리하게 하세요\",\"parking_at_branches\":\"분기점의 주차\",\"a_parking_place_lies_at\":\"주차 위치가 합류·분기점에 있음\",\"a_parking_place_is_a\":\"주차 위치가 스테이션의 바코드이기도 함: 유휴 차량이 길을 막을 수 있음\",\"parking_at_stations\":\"스테이션의 주차\",\"closed_a_barcode_cuts_off\":\"폐쇄하면 스테이션 위치가 최대 {0}곳 끊기는 바코드: 우회로 없음\",\"closed_a_barcode_cuts_off_2\":\"폐쇄하면 스테이션 위치 {1}곳 중 최대 {0}곳이 끊기는 바코드: 우회로 없음\",\"no_way_around\":\"우회로 없음\",\"a_bay_of_barcodes_a\":\"한 변이 바코드 {0}개인 베이에 지름길 {1}개의 자리 없음\",\"carriers_do_not_fit_ports\":\"캐리어 {0}개가 포트 {1}개에 들어가지 않음\",\"vehicles_do_not_fit_barcodes\":\"차량 {0}대가 들어가지 않음: 시작할 수 있는 바코드 {1}개\",\"bays_they_come_in_pairs\":\"베이 {0}개: 중앙 통로 양쪽에 하나씩 짝을 이루어야 함\",\"the_track_would_be_too\":\"트랙 간격이 너무 좁음: {0}\",\"column_pitch_and_lane_gap\":\"column {0}, pitch {1}, lane_gap {2} 이상\",\"columns_have_room_for_turnarounds\":\"열 {0}개에는 방향마다 회차로 {1}개의 자리가 있음\",\"leave_one_of_them_out\":\"둘 중 하나를 빼세요\",\"there_is_no_catalogue_its\":\"카탈로그 {0} 없음: 해당 드라이브는 원시값만 다룰 수 있음\",\"put_yaml_into_or_leave\":\"{0}.yaml을 {1}에 두거나 model을 빼세요\",\"zone_is_closed_and_of\":\"구역 {0} 폐쇄됨 ({1}), 그중 {2}이(가) 새 플랜트에 없음\",\"degree_needs_more_than_control\":\"차수 {0}에는 제어점이 {1}개보다 많아야 하나 {2}개임\",\"the_knot_vector_has_values\":\"매듭 벡터 값이 {1}개 필요하나 {0}개임\",\"the_knot_vector_does_not\":\"매듭 벡터가 증가하지 않음\",\"a_weight_is_not_above\":\"가중치가 0보다 크지 않음\",\"a_control_point_has_no\":\"제어점에 {0} 없음\",\"this_is_a_plant_file\":\"이미 플랜트 파일임\",\"see_what_is_wrong_with\":\"잘못된 점을 확인하세요: hoistway check FILE\",\"geojson_is_written_not_read\":\"GeoJSON은 쓰기만 하고 읽지 않음: 다음 마크를 알 수 없음\",\"a_lif_file_has_layouts\":\"LIF 파일에는 layouts, 노드-링크 그래프에는 nodes와 links가 있어야 합니다\",\"this_json_is_no_layout\":\"알려진 레이아웃 형식의 JSON이 아님\",\"opentcs_begins_with_model_graphml\":\"openTCS는 <model>, GraphML은 <graphml>로 시작해야 합니다\",\"this_xml_is_no_layout\":\"알려진 레이아웃 형식의 XML이 아님: <{0}>로 시작함\",\"where_on_earth_the_plant\":\"플랜트의 지구상 위치: 좌표는 도면상 미터임 (--origin을 쓰세요)\",\"names_of\":\"{0}의 이름\",\"soft_zones\":\"완화 구역 {0}개\",\"soft_zone\":\"완화 구역 {0}개\",\"this_json_is_no_node\":\"노드-링크 그래프 JSON이 아님\",\"it_is_an_object_with\":\"nodes와, links 또는 edges가 있는 객체여야 합니다\",\"the_graph_has_neither_links\":\"그래프에 links도 edges도 없음\",\"write_it_with_networkx_s\":\"networkx의 node_link_data로 쓰세요\",\"node_link_json\":\"노드-링크 JSON ({0}), {1}\",\"no_edges\":\"edges 없음\",\"ends_of_edges_are_positions\":\"구간의 끝이 노드 목록의 순번임 (networkx 1과 d3 방식)\",\"this_xml_is_no_graphml\":\"GraphML이 아님: graph가 없음\",\"node_line\":\"노드 {0} ({1}행)\",\"edge_line\":\"구간 ({0}행)\",\"the_graph_is_undirected_all\":\"무방향 그래프: 모든 트랙을 양방향으로 봄\",\"write_a_directed_graph_for\":\"일방통행 트랙은 방향 그래프로 쓰세요\",\"the_node_has_no_id\":\"노드에 id 없음: 제외\",\"attributes_that_are_not_understood\":\"알 수 없는 속성\",\"the_node_has_no_position\":\"노드에 위치 없음: 제외\",\"give_it_x_and_y\":\"x와 y, 또는 pos를 쓰세요\",\"a_station_without_an_id\":\"id 없는 스테이션: 제외\",\"give_it_one\":\"하나를 쓰세요\",\"the_edge_has_no_source\":\"구간에 source 또는 target 없음: 제외\",\"give_both\":\"둘 다 쓰세요\",\"correct_it\":\"고치세요\",\"write_true_or_false\":\"true 또는 false로 쓰세요\",\"there_is_no_mark_with\":\"{0}: 위치가 있는 마크 없음\",\"there_is_no_mark_with_2\":\"{0}: 위치가 있는 마크 없음: {1}\",\"marks_and_pieces_of_track\":\"마크 {0}개와 트랙 {1}조각\",\"are_more_than_a_plant\":\"{0}: 플랜트 파일의 한도를 넘음: {1}\",\"split_the_layout\":\"레이아웃을 나누세요\",\"several_files_make_one_layout\":\"여러 파일은 모두 표(CSV 또는 통합 문서)일 때만 한 레이아웃이 됨\",\"this_is_no_it_looks\":\"{0}이(가) 아님: {1}(으)로 보임\",\"leave_format_out\":\"--format을 빼세요\",\"imported_by_hoistway_layout_import\":\"hoistway layout import로 {0}에서 가져옴: {1}.\",\"wrong_in_the_source\":\"원본의 오류\",\"to_supply\":\"채울 것\",\"is_not_utf_8_at\":\"{0}은(는) UTF-8이 아님: {2}번째 바이트, {1}\",\"save_it_as_utf_8_2\":\"UTF-8로 저장하세요\",\"the_file_ends_in_the\":\"파일이 중간에 끝남: 온전히 복사했는지 확인하세요\",\"correct_it_there\":\"그곳을 고치세요\",\"is_no_json_line_column\":\"{0}은(는) JSON이 아님: {1}행 {2}열: {3}\",\"is_nested_too_deep_to\":\"{0}: 레이아웃이라기에는 너무 깊게 중첩됨\",\"is_no_json_that_can\":\"{0}은(는) 읽을 수 있는 JSON이 아님: {1}\",\"is_read_as\":\"{0}을(를) {1}(으)로 읽음\",\"is_a_number_where_a\":\"{0}: 텍스트 자리에 숫자가 있음\",\"is_no_text\":\"{0}은(는) 텍스트가 아님\",\"is_a_text_where_a\":\"{0}: 숫자 자리에 텍스트가 있음\",\"is_one_object_where_a\":\"{0}: 목록 자리에 객체 하나가 있음\",\"is_no_list\":\"{0}은(는) 목록이 아님\",\"write_it_in_brackets\":\"대괄호로 감싸세요\",\"is_no_object_left_out\":\"객체가 아님: 제외\",\"write_it_in_braces\":\"중괄호로 감싸세요\",\"how_vehicles_are_turned_on\":\"트랙 위 차량 방향\",\"where_vehicles_may_turn\":\"차량이 회전할 수 있는 곳\",\"how_fast_vehicles_may_turn\":\"차량 회전 속도\",\"heights_of_load_handling\":\"적재·하역 높이\",\"where_vehicles_may_be_taken\":\"차량을 제어에 넣을 수 있는 곳\",\"there_is_no_metainformation\":\"metaInformation 없음\",\"there_is_no_layoutid\":\"layoutId 없음\",\"there_is_no_layoutversion\":\"layoutVersion 없음\",\"lifversion_is_read_as\":\"lifVersion이 {0}: {1}(으)로 읽음\",\"lifversion_is_missing_read_as\":\"lifVersion 없음: {0}(으)로 읽음\",\"no_version\":\"(버전 없음)\",\"the_file_is_a_list\":\"layouts가 있는 객체 자리에 레이아웃 목록이 있음\",\"the_file_is_one_layout\":\"layouts가 있는 객체 자리에 레이아웃 하나가 있음\",\"this_json_holds_no_layouts\":\"JSON에 layouts 없음\",\"a_lif_file_is_an\":\"LIF 파일은 layouts가 있는 객체여야 합니다\",\"the_file_has_no_layouts\":\"파일에 layouts 없음\",\"a_lif_file_is_an_2\":\"LIF 파일은 layouts 목록이 있는 객체여야 합니다\",\"there_is_no_layout_in\":\"파일에 레이아웃 {0} 없음\",\"there_are_2\":\"있는 것: {0}\",\"the_node_has_no_nodeid\":\"노드에 nodeId 없음: 제외\",\"give_nodeposition_with_x_and\":\"nodePosition에 x와 y를 쓰세요\",\"x_and_y_stand_at\":\"nodePosition 없이 노드에 x와 y가 바로 있음\",\"no_vehicle_type_is_named\":\"노드에 차량 유형이 없음: 모든 유형으로 봄\",\"how_vehicles_are_turned_at\":\"노드에서의 차량 방향\",\"drawn_m_to_the_right\":\"다른 층 옆, 오른쪽 {0} m에 그림: 플랜트의 도면은 하나임\",\"or_import_one_layout_alone\":\"또는 --layout으로 하나만 가져오세요\",\"the_edge_has_no_edgeid\":\"구간에 edgeId 없음\",\"the_edge_has_no_startnodeid\":\"구간에 startNodeId 또는 endNodeId 없음: 제외\",\"an_edge_from_level_to\":\"층간 구간: 승강기는 주행하지 않음\",\"no_vehicle_type_is_named_2\":\"구간에 차량 유형이 없음: 모든 유형으로 봄\",\"edges_that_are_not_for\":\"차량 유형 {0}용이 아닌 구간\",\"the_trajectory_is_no_curve\":\"trajectory가 곡선이 아님({0}): 직선으로 봄\",\"track_for_loaded_vehicles_only\":\"적재 차량 전용 트랙: 모든 차량이 갈 수 있게 됨\",\"track_for_unloaded_vehicles_only\":\"빈 차량 전용 트랙: 모든 차량이 갈 수 있게 됨\",\"track_for_vehicles_only_any\":\"{0} 차량 전용 트랙: 모든 차량이 갈 수 있게 됨\",\"which_loads_may_be_carried\":\"그곳에서 운반할 수 있는 적재물\",\"actions_on_track\":\"트랙 위 동작\",\"there_are_no_stations_taken\":\"stations 없음: 스테이션이 없는 것으로 봄\",\"the_station_has_no_stationid\":\"스테이션에 stationId 없음: 제외\",\"the_height_of_stations\":\"스테이션 높이\",\"interactionnodeids_is_one_text_where\":\"interactionNodeIds: 목록 자리에 텍스트 하나가 있음\",\"node_of_it_is_nowhere\":\"스테이션의 노드 {0}이(가) 정의되지 않음\",\"correct_interactionnodeids\":\"interactionNodeIds를 고치세요\",\"vehicles_charge_at_the_node\":\"차량이 충전하는 노드인데 스테이션에 없음: 충전기로 만듦\",\"loads_are_handled_at_the\":\"적재·하역하는 노드인데 스테이션에 없음: 스테이션으로 만듦\",\"taken_is_what_any_vehicle\":\"어느 차량 유형이든 쓸 수 있는 것을 모두 가져옴: {0}\",\"or_choose_one_with_vehicle\":\"또는 --vehicle-type으로 하나를 고르세요\",\"no_vehicle_type_is_named_3\":\"차량 유형 {0} 없음: {1}\",\"lif\":\"LIF {0}, 이름 {1}\",\"speeds_in_percent\":\"퍼센트 속도 {0}개\",\"speed_in_percent\":\"퍼센트 속도 {0}개\",\"lengths_other_than_the_distance\":\"양 끝 거리와 다른 길이 {0}개\",\"length_other_than_the_distance\":\"양 끝 거리와 다른 길이 {0}개\",\"marks_of_curves\":\"곡선 표시 {0}개\",\"mark_of_curves\":\"곡선 표시 {0}개\",\"parking_places_2\":\"주차 위치 {0}곳\",\"parking_place\":\"주차 위치 {0}곳\",\"obstacle_sensor_areas_of_edges\":\"구간 {0}개의 장애물 센서 영역\",\"obstacle_sensor_areas_of_edge\":\"구간 {0}개의 장애물 센서 영역\",\"pulses_look_down_speed_and\":\"스테이션 {0}개의 펄스, look_down, 속도, 대체 스테이션\",\"pulses_look_down_speed_and_2\":\"스테이션 {0}개의 펄스, look_down, 속도, 대체 스테이션\",\"the_plant_s_clearance\":\"플랜트의 이격 거리\",\"process_codes\":\"공정 코드\",\"alarm_codes\":\"알람 코드\",\"event_numbers\":\"이벤트 번호\",\"process_codes_2\":\"공정 코드 {0}개\",\"process_code\":\"공정 코드 {0}개\",\"alarm_codes_2\":\"알람 코드 {0}개\",\"alarm_code\":\"알람 코드 {0}개\",\"event_numbers_2\":\"이벤트 번호 {0}개\",\"event_number\":\"이벤트 번호 {0}개\",\"when_agvs_charge\":\"AGV 충전 시기\",\"how_hoists_share_the_track\":\"호이스트의 트랙 공유 방식 (traffic)\",\"what_idle_hoists_do_idle\":\"유휴 호이스트의 동작 (idle)\",\"where_vehicles_connect_to_listen\":\"차량이 접속하는 곳 (listen)\",\"names_of_alarm_and_process\":\"알람·공정 코드 이름, 이벤트 번호\",\"buffer_and_alias_of_stations\":\"스테이션 {0}개의 버퍼와 별칭\",\"buffer_and_alias_of_station\":\"스테이션 {0}개의 버퍼와 별칭\",\"no_table_has_barcodes_with\":\"위치가 있는 바코드 표 없음: {0}(으)로 볼 열이 없음\",\"no_table_has_barcodes_with_2\":\"위치가 있는 바코드 표 없음: 세 열 barcode, x, y가 없음\",\"all_three\":\"세 가지 모두\",\"name_the_columns_barcode_x\":\"한 표의 열 이름을 barcode, x, y (바코드, X, Y)로 쓰세요\",\"a_column_that_is_not\":\"알 수 없는 열\",\"pieces_of_track\":\"트랙 조각\",\"a_table_that_says_nothing\":\"바코드에 대한 내용이 없는 표\",\"a_table_without_barcodes\":\"바코드가 없는 표\",\"the_row_has_no_barcode\":\"행에 바코드 없음: 제외\",\"fill_in_the_barcode\":\"바코드를 채우세요\",\"the_barcode_has_no_position\":\"바코드에 위치 없음: 제외\",\"fill_in_x_and_y\":\"x와 y를 채우세요\",\"one_length_for_several_ways\":\"여러 방향에 길이가 하나뿐임: 각각에 적용\",\"give_one_for_each\":\"방향마다 하나씩 쓰세요\",\"the_track_has_no_beginning\":\"트랙에 시작 또는 끝이 없음: 제외\",\"fill_in_both_barcodes\":\"두 바코드를 모두 채우세요\",\"write_one_way_or_two\":\"one-way 또는 two-way로 쓰세요\",\"write_yes_or_no\":\"yes 또는 no로 쓰세요\",\"only_some_of_shft_rota\":\"shft, rota, lift 중 일부만 있음: 제외\",\"give_all_three\":\"셋 다 쓰세요\",\"the_row_has_no_vehicle\":\"행에 차량 없음: 제외\",\"fill_in_its_name\":\"이름을 채우세요\",\"no_column_says_which_barcode\":\"다음 바코드를 알려 주는 열 없음: 도면에 트랙이 없게 됨\",\"add_a_column_next_or\":\"next(다음 바코드) 열을 추가하거나 --in-order를 쓰세요: 각 행이 다음 행으로 이어집니다 (--loop: 고리)\",\"at_most_are_made_up\":\"최대 {0}대까지만 만듦\",\"starts_at_which_is_nowhere\":\"시작 위치 {0}이(가) 정의되지 않음\",\"starts_at_where_another_vehicle\":\"시작 위치 {0}에 다른 차량이 있음\",\"no_barcode_is_free_where\":\"차량 길이만큼 비고 트랙으로 드나들 수 있는 시작 바코드 없음\",\"no_barcode_is_free_where_2\":\"{0}: 차량 길이만큼 비고 트랙으로 드나들 수 있는 시작 바코드 없음\",\"give_start_or_fewer_vehicles\":\"start를 쓰거나 차량을 줄이세요\",\"a_link_at_this_machine\":\"모의용, 이 컴퓨터의 링크\",\"write_the_real_line_s\":\"links 아래에 실제 회선의 address 또는 serial:을 쓰세요\",\"the_agv_s_number_on\":\"링크의 AGV 번호는 임의로 붙인 것\",\"write_the_real_one_as\":\"실제 번호를 dev_id에 쓰세요\",\"barcodes_are_no_numbers_so\":\"바코드가 숫자가 아니어서 텍스트 바코드용 프로토콜 변형을 씀\",\"see_dialects\":\"dialects를 확인하세요\",\"the_vehicle_s_number_is\":\"차량 번호는 임의로 붙인 것\",\"an_address_at_this_machine\":\"모의용, 이 컴퓨터의 주소\",\"write_the_real_one_as_2\":\"실제 주소를 address: HOST:PORT로 쓰세요\",\"vehicles_name_dev_id_and\":\"차량: 이름, dev_id, address\",\"vehicles_name_link_and_dev\":\"차량: 이름, link, dev_id\",\"under_vehicles_vehicles_n_makes\":\"vehicles 아래에 쓰세요. --vehicles N은 모의 차량을 만듭니다\",\"stations_where_carriers_are_taken\":\"스테이션: 캐리어를 들고 놓는 곳\",\"under_stations\":\"stations 아래에 쓰세요\",\"parking_where_idle_vehicles_may\":\"주차: 유휴 차량이 대기할 곳\",\"a_list_of_barcodes_under\":\"parking 아래에 바코드 목록을 쓰세요\",\"the_vehicle_s_offset_is\":\"차량의 OFFSET을 모름\",\"teach_it_docs_teaching_md\":\"티칭하거나(docs/teaching.md) offset을 쓰세요\",\"the_port_s_target_pulses\":\"포트의 목표 펄스를 모름\",\"teach_it_docs_teaching_md_2\":\"티칭하거나(docs/teaching.md) dest를 쓰세요\",\"agvs_read_tags_of_four\":\"AGV는 네 글자 태그를 읽음\",\"barcodes_are_numbers_or_texts\":\"바코드는 숫자 또는 여섯 글자 이하의 텍스트임\",\"renamed_give_your_own_with\":\"이름 변경: {0} (직접 정하려면 --names)\",\"renamed_and_its_letters_are_lost\":\"이름을 바꿨고 글자가 빠졌음: 이름은 로마자, 숫자, . _ - : + @ 만 가능\",\"write_the_names_into_the_list\":\"상위 시스템이 쓸 이름을 목록에 적고 다시 가져오세요\",\"renamed_names_are_letters_digits\":\"이름 변경: 이름은 영문자, 숫자, . _ - : + @ 로 쓰고 중복될 수 없음\",\"shown_on_vehicles_so_their\":\"차량 표시: 표시창이 {0}자까지임\",\"is_no_number\":\"{0}은(는) 숫자가 아님\",\"the_number_is_too_large\":\"숫자가 너무 큼\",\"the_number_is_too_large_2\":\"{0}: 숫자가 너무 큼\",\"is_no_finite_number\":\"{0}은(는) 유한한 숫자가 아님\",\"a_closed_path_opentcs_lets\":\"닫힌 경로: openTCS에서 주행할 수 없음\",\"the_root_element_is_not\":\"최상위 요소가 model이 아니라 {0}임\",\"opentcs_plant_model\":\"openTCS 플랜트 모델 {0}, {1}\",\"opentcs_plant_model_no_version\":\"openTCS 플랜트 모델 (버전 없음), {0}\",\"version_is_read_like_versions\":\"버전 {0}을(를) 버전 {1}처럼 읽음\",\"version_is_read_like_versions_2\":\"버전 {0}을(를) 버전 {1}·{2}처럼 읽음\",\"elements_that_are_not_known\":\"알 수 없는 요소\",\"it_has_no_name_left\":\"이름 없음: 제외\",\"the_point_has_no_position\":\"점에 위치 없음: 제외\",\"give_positionx_and_positiony\":\"positionX와 positionY를 쓰세요\",\"heights_of_points_a_plant\":\"점의 높이: 플랜트의 도면은 하나임\",\"how_vehicles_are_turned_at_2\":\"점에서의 차량 방향\",\"the_point_has_no_position_2\":\"점에 자체 위치 없음: 그림의 위치를 씀\",\"the_path_has_no_sourcepoint\":\"경로에 sourcePoint 또는 destinationPoint 없음: 제외\",\"keep_it_with_keep_locked\":\"--keep-locked로 남기고 운영 중인 플랜트에서 폐쇄하세요\",\"a_locked_path_close_it\":\"잠긴 경로: 운영 중인 플랜트에서 폐쇄하세요\",\"operations_of_peripherals_on_paths\":\"경로의 주변 장치 동작\",\"doors_are_given_under_doors\":\"도어는 doors 아래에 쓰세요\",\"no_speed_either_way_nobody\":\"양방향 모두 속도 없음: 주행할 수 없음\",\"driven_backwards_as_well_two\":\"후진 주행도 함: 양방향 트랙\",\"drop_the_run_that_leads\":\"필요 없으면 돌아오는 쪽을 빼세요\",\"its_type_is_nowhere_given\":\"유형 {0}이(가) 정의되지 않음\",\"a_locked_location_put_it\":\"잠긴 위치: 운영 중인 플랜트에서 사용 중지하세요\",\"a_location_that_is_linked\":\"점과 이어지지 않은 위치\",\"give_it_a_station_at\":\"바코드에 스테이션을 쓰세요\",\"blocks_of_type\":\"유형 {0}의 블록\",\"its_member_is_nowhere_given\":\"구성원 {0}이(가) 정의되지 않음\",\"correct_or_leave_it_out\":\"고치거나 빼세요\",\"left_out\":\"제외\",\"to_supply_2\":\"채울 것\",\"the_layout_has_no_such\":\"레이아웃에 그런 마크 없음\",\"correct_it_in_the_file\":\"이름 파일에서 고치세요\",\"the_position_is_no_number\":\"위치가 숫자가 아니어서 마크를 제외\",\"give_x_and_y\":\"x와 y를 쓰세요\",\"the_position_is_more_than\":\"위치가 {0} km보다 멂\",\"is_given_again_alike\":\"{0}이(가) 똑같이 또 있음 ({1})\",\"is_given_twice_at_different\":\"{0}이(가) 다른 위치에 중복됨: 첫 번째를 씀 ({1})\",\"lies_where_another_node_lies\":\"다른 노드와 위치가 같아 마크 하나로 합침 (회전과 층은 구분하지 않음)\",\"leads_to_which_is_nowhere\":\"이어지는 {0}이(가) 정의되지 않음: 제외\",\"give_the_mark_a_position\":\"마크에 위치를 쓰거나 트랙을 빼세요\",\"leads_from_a_mark_to\":\"마크에서 자기 자신으로 이어짐\",\"leads_from_node_to_node\":\"같은 위치의 노드 사이: 차량이 스스로 하는 회전\",\"the_same_track_is_given\":\"같은 트랙이 또 있음\",\"a_second_way_between_the\":\"같은 두 마크 사이의 두 번째 길: 첫 번째를 씀\",\"the_length_is_no_number\":\"길이가 숫자가 아님: 양 끝의 거리를 씀\",\"the_length_is_below_zero\":\"길이가 0보다 작음: 양 끝의 거리를 씀\",\"the_length_is_0_taken\":\"길이가 0: 양 끝의 거리를 씀\",\"both_ends_lie_at_one\":\"양 끝이 같은 위치이고 길이가 없음: 제외\",\"correct_a_position_or_give\":\"위치를 고치거나 길이를 쓰세요\",\"longer_than_km_left_out\":\"{0} km보다 김: 제외\",\"the_speed_is_not_above\":\"속도가 0보다 크지 않음: 100 %로 봄\",\"the_speed_is_above_the\":\"속도가 차량 자체 속도보다 큼: 100 %로 봄\",\"is_a_station_already_left\":\"{0}은(는) 이미 스테이션임 ({1}): 제외\",\"its_mark_is_nowhere_given\":\"마크 {0}이(가) 정의되지 않음\",\"its_mark_is_nowhere_given_2\":\"마크 {0}이(가) 정의되지 않음: 제외\",\"no_mark_is_named_for\":\"지정된 마크 없음\",\"no_mark_is_named_for_2\":\"지정된 마크 없음: 제외\",\"name_the_mark_where_vehicles\":\"차량이 서는 마크를 쓰세요\",\"a_station_is_reached_from\":\"스테이션은 마크 하나에서 처리됨: {0}을(를) 씀\",\"give_stations_of_their_own\":\"나머지에도 캐리어가 놓이면 스테이션을 따로 쓰세요\",\"cannot_be_a_carrier_letters\":\"{0}은(는) 캐리어가 될 수 없음: 영문자·숫자 {1}자까지, 중복 없이\",\"correct_its_name\":\"이름을 고치세요\",\"hoists_do_not_charge\":\"호이스트는 충전하지 않음\",\"vehicles_are_mm_long\":\"파일에 없는 값: 차량 길이 {0} mm, 최고 속도 {1} mm/s, 감속도 {2} mm/s²로 가정\",\"write_what_is_true_under\":\"실제 값을 vehicle_defaults에 쓰세요\",\"clearance_is_0\":\"clearance 0: 나란한 트랙은 서로 배제하지 않음\",\"write_it_in_mm_as_clearance\":\"mm 단위로 clearance에 쓰세요\",\"agvs_charge_after_trips_or\":\"AGV는 반송 {0}회 또는 1시간마다 충전: 레이아웃에 시기가 없음\",\"say_when_under_charging\":\"charging 아래에 시기를 쓰세요\",\"in_it_is_nowhere_given\":\"구역의 {0}이(가) 정의되지 않음\",\"a_zone_without_marks\":\"마크가 없는 구역\",\"no_row_names_columns_that\":\"{0}: 알려진 열 이름이 있는 행 없음\",\"this_is_no_text_it\":\"텍스트가 아님: 0 바이트가 들어 있음\",\"give_csv_xlsx_json_or\":\"CSV, XLSX, JSON, XML 중 하나를 쓰세요\",\"this_is_no_text_in\":\"{0} 텍스트가 아님\",\"name_its_encoding_with_encoding\":\"--encoding으로 인코딩을 쓰세요\",\"unknown_encoding\":\"알 수 없는 인코딩 {0}\",\"more_than_rows\":\"{0}행보다 많음\",\"is_a_quotation_mark_left\":\"닫히지 않은 따옴표가 있는지 확인하세요\",\"row\":\"{0}행: {1}\",\"save_it_anew_as_xlsx\":\"암호 없는 XLSX나 CSV로 다시 저장하세요\",\"is_no_workbook_that_can\":\"{0}은(는) 읽을 수 있는 통합 문서가 아님: {1}\",\"no_row_names_columns_that_2\":\"알려진 열 이름이 있는 행 없음\",\"no_sheet_has_columns_that\":\"{0}: 알려진 열이 있는 시트 없음\",\"workbook_sheets\":\"통합 문서, 시트 {0}\",\"is_a_damaged_workbook\":\"{0}: 손상된 통합 문서: {1}\",\"save_it_anew\":\"다시 저장하세요\",\"unpacks_to_mb_that_is\":\"{0}을(를) 풀면 {1} MB: 바코드 목록이 아님\",\"needed_are_at_least_a\":\"barcode(바코드), x, y와 next(다음 바코드), 또는 from과 to가 필요합니다\",\"needed_are_at_least_a_2\":\"barcode(바코드), x, y와 next(다음 바코드), 또는 from과 to가 필요합니다. 첫 행: {0}\",\"positions_are_in_the_file\":\"위치 단위 {0}(으)로 봄: 파일에 단위 없음\",\"say_unit_mm_or_unit\":\"--unit mm 또는 --unit m을 쓰세요\",\"y_grows_downwards_as_on\":\"y는 화면처럼 아래로 커지는 것으로 봄\",\"say_y_up_if_the\":\"도면이 뒤집히면 --y-up을 쓰세요\",\"lengths_are_in_as_the\":\"위치로 보아 길이 단위는 {0}\",\"name_the_unit_length_m\":\"단위를 쓰세요: length (m)\",\"shares_of_the_vehicles_own\":\"차량 자체 속도에 대한 비율\",\"percent_of_the_vehicles_own\":\"차량 자체 속도에 대한 퍼센트\",\"speeds_are\":\"속도 단위: {0}\",\"name_the_unit_speed_or\":\"단위를 쓰세요: speed (%) 또는 speed (mm/s)\",\"declares_a_document_type_or\":\"{0}: 레이아웃에 필요 없는 문서 유형이나 엔티티 선언이 있어 거부함\",\"export_it_anew_without_a\":\"DOCTYPE 없이 다시 내보내세요\",\"is_no_xml_line_column\":\"{0}은(는) XML이 아님: {1}행 {2}열: {3}\",\"is_no_xml_that_can\":\"{0}은(는) 읽을 수 있는 XML이 아님: {1}\",\"vehicle_is_not_connected\":\"차량 {0} 연결되지 않음\",\"check_its_power_and_its\":\"전원과 네트워크를 확인하세요. 자동으로 다시 접속합니다\",\"vehicle_has_not_yet_answered\":\"차량 {0}: 연결 후 아직 STATUS 응답 없음\",\"try_again_once_it_has\":\"응답이 오면 다시 시도하세요\",\"the_newest_status_of_vehicle\":\"차량 {0}의 마지막 STATUS가 {1}초 전임\",\"the_newest_status_of_is\":\"{0}의 마지막 STATUS가 {1}초 전임\",\"try_again_once_it_answers\":\"STATUS에 응답하면 다시 시도하세요\",\"vehicle_has_not_yet_answered_2\":\"차량 {0}: 아직 {1} 응답 없음\",\"has_not_yet_answered_status\":\"{0}: 연결 후 아직 STATUS 응답 없음\",\"has_not_yet_answered\":\"{0}: 아직 {1} 응답 없음\",\"wait_for_its_answer_or\":\"응답을 기다리거나 차량을 정지하세요\",\"the_path_has_elements_and\":\"경로 요소 {0}개: 차량 {1}은(는) 최대 {2}개까지 받음\",\"the_path_has_elements_and_2\":\"경로 요소 {0}개: {1}은(는) 최대 {2}개까지 받음\",\"send_the_first_part_and\":\"앞부분을 보내고 XMOVE로 늘리세요\",\"vehicle_is_in_manual\":\"차량 {0} MANUAL 상태\",\"vehicle_is_in_semi\":\"차량 {0} SEMI 상태\",\"vehicle_is_in_auto\":\"차량 {0} AUTO 상태\",\"vehicle_is_in_an_undefined\":\"차량 {0} 정의되지 않은 모드\",\"switch_it_to\":\"{0}(으)로 바꾸세요\",\"switch_it_to_or\":\"{0} 또는 {1}(으)로 바꾸세요\",\"alarm_0x\":\"알람 {0} (0x{1})\",\"refused_or_broken_off_without\":\"사유 없이 거부 또는 중단됨. 차량 상태: {0}\",\"refused_or_broken_off_without_2\":\"사유 없이 거부 또는 중단됨. 차량 상태: {0}\",\"an_undefined_mode\":\"정의되지 않은 모드\",\"an_undefined_mode_2\":\"정의되지 않은 모드, {0}\",\"servos_off\":\"서보 꺼짐\",\"home_not_known\":\"원점 모름\",\"not_all_devices_at_home\":\"일부 장치 원점 아님\",\"servos_off_2\":\"{0}, 서보 꺼짐\",\"home_not_known_2\":\"{0}, 원점 모름\",\"not_all_devices_at_home_2\":\"{0}, 일부 장치 원점 아님\",\"servos_off_home_not_known\":\"{0}, 서보 꺼짐, 원점 모름\",\"servos_off_not_all_devices\":\"{0}, 서보 꺼짐, 일부 장치 원점 아님\",\"home_not_known_not_all\":\"{0}, 원점 모름, 일부 장치 원점 아님\",\"servos_off_home_not_known_2\":\"{0}, 서보 꺼짐, 원점 모름, 일부 장치 원점 아님\",\"barcode_is_not_on_the\":\"지도에 없는 바코드 {0}\",\"barcode_is_not_on_the_2\":\"지도에 없는 바코드 {0}: 프로토콜 변형과 레이아웃을 확인하세요\",\"barcode_is_not_on_the_3\":\"지도에 없는 바코드 {0}. barcode_bytes {1}(으)로 읽으면 지도에 있는 {2}: 프로토콜 변형 {3}을(를) 써 보세요\",\"itsc_has_no_command_of\":\"iTSC에 AGV 명령 없음\",\"send_it_to_an_agv_2\":\"AGV에 보내세요\",\"a_port_needs_target_pulses\":\"포트에는 목표 펄스가 필요함\",\"teach_the_port_or_give\":\"포트를 티칭하거나 플랜트 파일에 펄스를 쓰세요\",\"alarm_0x_may_be_one\":\"알람 0x{0}은(는) 차량 자체 알람일 수 있음\",\"choose_a_number_from_0x\":\"0x{0}~0x{1}의 번호를 고르세요\",\"barcode_is_no_decimal_number\":\"바코드 {0}은(는) 앞자리 0 없는 십진수가 아님\",\"write_it_in_the_plant\":\"차량이 보고하는 대로 플랜트 파일에 쓰거나 barcode_format ascii인 프로토콜 변형을 고르세요\",\"foreign_dev_id\":\"다른 DEV_ID\",\"the_vehicle_has_dev_id\":\"차량의 DEV_ID는 {0}, 패킷은 {1}\",\"a_vehicle_sends_no_etb\":\"차량은 ETB 패킷을 보내지 않음\",\"another_epoch\":\"이전 실행의 응답\",\"cmd_id_0x_was_given\":\"CMD_ID 0x{0}은(는) 제어기의 이전 실행에서 부여한 것\",\"code_0x_is_no_answer\":\"코드 0x{0}은(는) 알려진 응답도 이벤트도 아님\",\"status_answers_cmd_id_0x\":\"STATUS가 진행 중이 아닌 CMD_ID 0x{0}에 응답함\",\"unasked_answer\":\"묻지 않은 응답\",\"cmd_id_0x_with_code\":\"코드 0x{1}의 CMD_ID 0x{0}은(는) 진행 중이 아님\",\"code_0x_answers_code_0x\":\"코드 0x{1}에 코드 0x{0}(으)로 응답함\",\"unfit_answer\":\"맞지 않는 응답\",\"unfit_packet\":\"맞지 않는 패킷\",\"unknown_code\":\"알 수 없는 코드 {0}\",\"is_no_format_of\":\"{0}은(는) {1}의 형식이 아님\",\"length_does_not_fit_elements\":\"LENGTH {0}이(가) 요소 {1}개와 맞지 않음 ({2})\",\"count_but_elements\":\"COUNT {0}, 실제 요소 {1}개\",\"the_path_is_empty\":\"경로가 비어 있음\",\"the_first_seq_is_not\":\"첫 SEQ가 0이 아니라 {0}임\",\"seq_follows\":\"SEQ {1} 다음에 {0}이(가) 옴\",\"the_last_element_is_not\":\"마지막 요소가 정지가 아님\",\"is_not_printable_ascii\":\"{0} {1}: 인쇄 가능한 ASCII가 아님\",\"seq_is_outside\":\"SEQ {0}: {1}이(가) {2}..{3}을(를) 벗어남\",\"move_needs_an_etb_packet\":\"MOVE에는 ETB 패킷이 필요함\",\"xmove_needs_an_etb_packet\":\"XMOVE에는 ETB 패킷이 필요함\",\"needs_an_etb_packet\":\"{0}에는 ETB 패킷이 필요함\",\"does_not_travel_in_an\":\"{0}은(는) ETB 패킷으로 보내지 않음\",\"does_not_fit_in_an\":\"{0}은(는) ENQ 패킷에 들어가지 않음\",\"bytes_of_sub_data_at\":\"서브 데이터 {0}바이트, 최대 {1} (max_sub)\",\"length_at_most_bytes_of\":\"LENGTH {0}: 서브 데이터는 최대 {1}바이트 (max_sub)\",\"dev_id_does_not_fit\":\"DEV_ID {0}이(가) 32비트에 들어가지 않음\",\"cmd_id_does_not_fit\":\"CMD_ID {0}이(가) 64비트에 들어가지 않음\",\"a_field_of_the_header\":\"헤더 필드가 범위를 벗어남\",\"of_bytes_then_silence\":\"{1}바이트 중 {0}바이트 뒤 끊김\",\"length_is_more_than\":\"LENGTH {0}이(가) {1}보다 큼\",\"crc_expected\":\"{0}: CRC {1}, 기댓값 {2}\",\"etb_header_crc_expected\":\"ETB 헤더: CRC {0}, 기댓값 {1}\",\"sub_packet_crc_expected\":\"서브 패킷: CRC {0}, 기댓값 {1}\",\"bytes_of_a_packet_then\":\"패킷 {0}바이트 뒤 끊김\",\"bytes_dropped\":\"{0}바이트 버림\",\"len_is_more_than\":\"LEN {0}이(가) {1}보다 큼\",\"byte_starts_no_packet\":\"바이트 {0}은(는) 패킷의 시작이 아님\",\"len_is_not_from_1\":\"LEN {0}이(가) 1~{1}을(를) 벗어남\",\"byte_stands_in_the_place\":\"ETX 자리에 바이트 {0}이(가) 있음\",\"crc_bytes_expected\":\"CRC 바이트 {0}, 기댓값 {1}\",\"unknown_command\":\"알 수 없는 명령\",\"no_status_for_s\":\"{0}초 동안 Status 없음\",\"the_link_is_down\":\"링크 끊김\",\"connect_it\":\"연결하세요\",\"it_has_not_reported_for\":\"한동안 보고 없음\",\"see_whether_it_is_switched\":\"전원이 켜져 있는지 확인하세요\",\"is_under_way\":\"{0} 진행 중\",\"wait_until_it_has_ended\":\"끝날 때까지 기다리세요\",\"overtaken_by\":\"뒤이은 {0}(으)로 대체됨\",\"it_has_not_ended_within\":\"{0}초 안에 끝나지 않음\",\"status_shows_no_effect\":\"Status에 변화 없음\",\"see_whether_the_device_does\":\"장치가 명령대로 동작하는지 확인하세요\",\"it_reports_to_be_in\":\"태그 {1}이(가) 아니라 {0}에서 목적 위치 도달을 보고함\",\"the_agv_reports_an_error\":\"AGV가 오류를 보고함, 마지막 태그 {0}\",\"the_agv_was_turned_to\":\"AGV가 수동으로 전환됨, 마지막 태그 {0}\",\"it_stands_last_tag\":\"정지해 있음, 마지막 태그 {0}\",\"the_agv_reports_an_error_2\":\"AGV가 오류를 보고함\",\"the_lift_is_up_again\":\"리프트가 다시 상승 상태\",\"the_lift_is_down_again\":\"리프트가 다시 하강 상태\",\"the_lift_is_again\":\"리프트가 다시 {0} 상태\",\"the_buffer_reports_an_error\":\"버퍼가 오류를 보고함\",\"the_door_reports_error\":\"도어가 오류를 보고함\",\"the_door_reports_open\":\"도어가 열림을 보고함\",\"the_door_reports_closed\":\"도어가 닫힘을 보고함\",\"the_door_reports\":\"도어가 {0} 상태를 보고함\",\"it_reports_an_error\":\"오류를 보고함\",\"see_what_is_wrong_at\":\"장치의 이상을 확인하세요\",\"the_agv_is_in_error\":\"AGV 오류 상태\",\"see_what_is_wrong_at_2\":\"AGV의 이상을 확인한 뒤 Reset을 보내세요\",\"the_agv_does_not_stand\":\"AGV가 멈춰 있지 않음\",\"stop_it_first\":\"먼저 정지하세요\",\"the_agv_is_in_manual\":\"AGV 수동 상태\",\"the_agv_is_in_auto\":\"AGV 자동 상태\",\"switch_it_to_manual_at\":\"AGV에서 수동으로 바꾸세요\",\"number_is_no_s_in\":\"{0}: 번호 {1}은(는) 이 프로토콜 변형에서 {2} 번호가 아님\",\"two_devices_of_this_link\":\"{0}: 이 링크에 같은 이름이나 번호 {1}의 장치가 둘 있음\",\"connected_anew\":\"다시 연결됨\",\"no_valid_packet_for_s\":\"{0}초 동안 유효한 패킷 없음\",\"is_not_on_this_link\":\"{0}은(는) 이 링크에 없음\",\"foreign_device\":\"등록되지 않은 장치\",\"device_is_not_configured_on\":\"장치 {0}은(는) 이 링크에 설정되지 않음\",\"stx_without_a_packet_of\":\"STX 뒤에 규정된 형식의 패킷 없음\",\"the_packet_ends_in_neither\":\"패킷이 ETX나 ETB가 아닌 {0}(으)로 끝남\",\"bcc_expected\":\"BCC {0}, 기댓값 {1}\",\"packets_that_were_to_be\":\"이어질 예정이던 패킷 {0}개\",\"semi_step\":\"반자동 스텝\",\"auto_step\":\"자동 스텝\",\"reciprocating_operation\":\"왕복 운전\",\"is_no_whole_number_from\":\"{0} {1}은(는) 0~{2}의 정수가 아님\",\"drive_address_is_not_from\":\"드라이브 {0}: 주소 {1}이(가) 1~{2}을(를) 벗어남\",\"drive_its_name_or_its\":\"드라이브 {0}: 이름 또는 주소 {1}이(가) 이미 회선에 있음\",\"another_master_is_on_the\":\"회선에 다른 마스터가 있음\",\"it_answers_nothing_that_was\":\"요청하지 않은 응답\",\"another_master_is_on_the_2\":\"{0}: 회선에 다른 마스터가 있음\",\"it_answers_nothing_that_was_2\":\"{0}: 요청하지 않은 응답\",\"stray_packet\":\"엉뚱한 패킷\",\"press_stop_reset_once_its\":\"원인을 없앤 뒤 정지/리셋을 누르세요\",\"the_drive_did_not_answer\":\"드라이브 응답 없음\",\"the_drive_is_in_error\":\"드라이브 에러 {0} {1}\",\"the_drive_took_the_command\":\"에러 모드라 명령을 받았으나 움직이지 않음\",\"the_drive_is_still_in\":\"정지/리셋 후에도 드라이브 에러\",\"remove_the_cause_then_press\":\"원인을 없앤 뒤 다시 누르세요\",\"the_status_does_not_show\":\"상태로는 키가 받아들여졌는지 알 수 없음\",\"the_drive_did_not_take\":\"드라이브가 {0}회 송신한 키를 받지 않음\",\"written_but_not_read_back\":\"썼으나 되읽지 못함: {0}\",\"written_but_not_read_back_2\":\"{0}: 썼으나 되읽지 못함: {1}\",\"parameter_reads_back_as_not\":\"파라미터 {0} 되읽은 값 {1}, 쓴 값 {2}\",\"parameter_reads_back_as_not_2\":\"{0}: 파라미터 {1} 되읽은 값 {2}, 쓴 값 {3}\",\"it_is_out_of_range\":\"범위를 벗어났거나 읽기 전용이거나 다른 파라미터가 써졌을 수 있음: 모두 비교하세요\",\"write_them_one_by_one\":\"하나씩 쓰세요\",\"the_jog_has_ended_but\":\"조그는 끝났으나 {0}\",\"the_drive_is_in_mode\":\"드라이브가 조그가 아니라 모드 {0}\",\"the_drive_went_to_mode\":\"조그 중 드라이브가 모드 {0}(으)로 바뀜\",\"the_drive_did_not_take_2\":\"드라이브가 조그 키를 연속 {0}회 받지 않음\",\"another_jog_has_the_line\":\"다른 조그가 회선을 쓰는 중\",\"wait_until_it_is_over\":\"끝날 때까지 기다리세요\",\"there_is_no_such_drive\":\"그런 드라이브 없음\",\"drive_is_not_on_line\":\"드라이브 {0}은(는) 회선 {1}에 없음\",\"line_is_down\":\"회선 {0} 끊김\",\"the_drive_is_offline\":\"드라이브 오프라인\",\"switch_it_on_and_check\":\"전원을 켜고 케이블과 ID를 확인하세요\",\"only_one_drive_at_a\":\"한 번에 드라이브 하나만 응답할 수 있음\",\"ask_them_one_by_one\":\"하나씩 요청하세요\",\"in_error\":\"에러 상태: {0}\",\"reset_them_first\":\"먼저 리셋하세요\",\"stop_reset_was_pressed\":\"정지/리셋을 누름\",\"the_drive_is_busy_bsy\":\"드라이브 동작 중: {0}에 BSY\",\"no_answer_to_in_transmissions\":\"{0}에 {1}회 송신했으나 응답 없음\",\"no_answer_to_in_transmission\":\"{0}에 {1}회 송신했으나 응답 없음\",\"no_answer_to_in_transmission_2\":\"{0}에 {1}회 송신했으나 응답 없음. 이어서 {2}에도 {3}회 송신했으나 응답 없음\",\"no_answer_to_in_transmissions_2\":\"{0}에 {1}회 송신했으나 응답 없음. 이어서 {2}에도 {3}회 송신했으나 응답 없음\",\"nak_to_in_transmissions\":\"{0}에 {1}회 송신, NAK\",\"nak_to_in_transmission\":\"{0}에 {1}회 송신, NAK\",\"then_the_drive_did_not\":\"이어서 드라이브 응답 없음\",\"the_drive_went_offline\":\"드라이브 오프라인이 됨: {0}\",\"say_both_or_neither\":\"둘 다 적거나 둘 다 빼십시오.\",\"lies_outside\":\"{0}: {1}년~{2}년을 벗어남\",\"lies_outside_2\":\"{0}년~{1}년을 벗어남\",\"timezone_info\":\"{0}: 시간대가 없음. 예: 2026-07-01T08:30:00Z 또는 2026-07-01T17:30:00+09:00\",\"valid_datetime\":\"{0}: 올바른 날짜와 시각이 아님 ({1})\",\"valid_boolean_2\":\"{0}: true 또는 false여야 함\",\"list_at_least\":\"{0}: 항목이 {1}개 이상이어야 함 (현재 {2}개)\",\"list_at_most\":\"{0}: 항목이 {1}개 이하여야 함 (현재 {2}개)\",\"no_event_named\":\"{0}: 이벤트 {1} 없음\",\"raw_unicode\":\"{0}: 올바른 유니코드 문자열이 아님\",\"a_sheet_reaches\":\"{0}: 시트가 {1}행 {2}열까지 펼쳐져 있음\",\"delete_what_stands_far\":\"목록에서 멀리 떨어진 셀을 지우고 다시 저장하세요\",\"0_or_1\":\"{0}' 또는 '{1}\",\"0_input_should_be_a_finite\":\"{0}: 유한한 수여야 함\",\"no_colon_can_stand_here_put\":\"여기에 콜론을 쓸 수 없음: 콜론이 든 글은 따옴표로 감싸거나 줄을 바꾸세요\",\"no_value_begins_so_indent_with\":\"값이 이렇게 시작할 수 없음: 탭이 아니라 공백으로 들여 쓰고 글은 따옴표로 감싸세요\",\"a_comma_is_missing_here_or\":\"쉼표가 빠졌거나 괄호가 닫히지 않음\",\"the_next_item_of_the_list\":\"여기에 목록의 다음 항목(-)이 있어야 함: 들여쓰기를 확인하세요\",\"a_key_is_expected_here_look\":\"여기에 키가 있어야 함: 들여쓰기를 확인하세요\",\"a_text_in_quotes_is_not\":\"따옴표가 닫히지 않음\",\"this_is_no_escape_in_double\":\"큰따옴표 속 이스케이프가 아님: 역슬래시 자체는 두 번 씀\",\"a_colon_is_expected_behind_the\":\"키 뒤에 콜론이 있어야 함\",\"a_tab_stands_where_blanks_indent\":\"들여쓰기에 탭이 있음: 공백을 쓰세요\",\"a_value_is_expected_here\":\"여기에 값이 있어야 함\",\"the_document_has_ended_before_this\":\"문서는 이 앞에서 끝났음\",\"this_character_is_none_that_a\":\"글에 쓸 수 없는 문자임\",\"a_list_begins_on_a_line\":\"목록은 새 줄에서 시작해야 함\",\"a_mapping_begins_on_a_line\":\"매핑은 새 줄에서 시작해야 함\",\"this_cannot_stand_here_0\":\"여기에 올 수 없음 ({0})\",\"this_is_a_recording_get_api\":\"녹화된 기록입니다: 한순간의 내용은 GET /api/v1/history?at=시각, 담긴 기간은 GET /api/v1/history/span에서 볼 수 있습니다.\",\"the_name_0_is_not_found\":\"이름 {0}을(를) 찾을 수 없음 ({1})\",\"its_certificate_is_not_trusted_0\":\"인증서를 믿을 수 없음 ({0})\",\"tls_is_not_agreed_on_0\":\"TLS 연결이 성립하지 않음 ({0})\",\"no_connection_within_0_s\":\"{0}초 안에 연결되지 않음\",\"0_refuses_the_connection\":\"{0}이(가) 연결을 거부함\",\"0_cannot_be_reached_1\":\"{0}에 닿을 수 없음 ({1})\",\"the_connection_ended_without_an_answer\":\"답 없이 연결이 끝남\",\"answered_0_1\":\"{0} 응답: {1}\",\"answered_0\":\"{0} 응답\",\"version_numbered\":\"버전 {0}\"}");
var events = {
	"TransferInitiated": "반송 시작 등록",
	"VehicleAssigned": "차량 배정",
	"VehicleUnassigned": "차량 배정 해제",
	"VehicleDeparted": "차량 출발",
	"VehicleArrived": "차량 도착",
	"Transferring": "반송 중",
	"VehicleAcquireStarted": "적재 시작",
	"VehicleAcquireCompleted": "적재 완료",
	"CarrierInstalled": "캐리어 탑재",
	"CarrierRemoved": "캐리어 하역",
	"VehicleDepositStarted": "하역 시작",
	"VehicleDepositCompleted": "하역 완료",
	"TransferCompleted": "반송 완료",
	"TransferAbortInitiated": "중단 시작",
	"TransferAbortCompleted": "중단 완료",
	"TransferAbortFailed": "중단 실패",
	"TransferCancelInitiated": "취소 시작",
	"TransferCancelCompleted": "취소 완료",
	"TransferCancelFailed": "취소 실패",
	"TransferPaused": "반송 일시정지",
	"TransferResumed": "반송 재개",
	"AlarmSet": "알람 발생",
	"AlarmCleared": "알람 해제",
	"VehicleHeld": "차량 보류",
	"VehicleReleased": "차량 해제",
	"VehicleRemoved": "차량 제거",
	"VehicleInstalled": "차량 투입",
	"VehicleBrokenDown": "차량 고장",
	"VehicleMended": "차량 복구",
	"TransferUpdated": "반송 변경",
	"ControllerAuto": "제어기 자동",
	"ControllerPausing": "제어기 일시정지 중",
	"ControllerPaused": "제어기 일시정지",
	"PortStateChanged": "포트 상태 변경",
	"CarrierLocationChanged": "캐리어 위치 변경",
	"TeachingApproved": "티칭 승인",
	"PlaceClosing": "폐쇄 진행",
	"TeachingSessionOpened": "티칭 세션 시작",
	"ZoneResumed": "구역 재개",
	"TeachingSessionEnded": "티칭 세션 종료",
	"TeachingTaken": "티칭 수신",
	"DriveParameterWritten": "드라이브 파라미터 변경",
	"DriveOnline": "드라이브 온라인",
	"TeachingImported": "티칭 가져오기",
	"DriveOffline": "드라이브 오프라인",
	"EmergencySet": "비상 상황 발생",
	"PlaceClosed": "폐쇄 완료",
	"TeachingRejected": "티칭 반려",
	"TeachingCodeUnknown": "알 수 없는 티칭 코드",
	"EmergencyReleased": "비상 상황 해제",
	"PlaceOpened": "폐쇄 해제",
	"TeachingRolledBack": "티칭 되돌림",
	"DeviceChanged": "장치 상태 변경",
	"DriveErrorCleared": "드라이브 오류 해제",
	"ZonePaused": "구역 일시정지",
	"DriveErrorSet": "드라이브 오류 발생",
	"WalkStarted": "재고 실사 시작",
	"WalkEnded": "재고 실사 종료"
};
var pages = {
	"mend_that_give_it_another": "원인을 해결하거나, 작업 {0}에 다른 목적지를 주거나, ‘취소’를 누르세요",
	"this_is_a_recording_get_api": "녹화된 기록입니다: 담긴 내용은 ‘재생’에서 볼 수 있습니다.",
	"log_in_or_send": "로그인하세요.",
	"clear_the_cause_then_post": "원인을 없앤 뒤 {0}에서 ‘알람 복구’를 누르세요",
	"see_what_is_wrong_then": "원인을 확인한 뒤 {0}에서 ‘알람 복구’를 누르세요",
	"mend_the_cause_then_post": "원인을 고친 뒤 {0}에서 다시 ‘알람 복구’를 누르세요",
	"post_api_v_vehicles_recover": "연결되면 {0}에서 다시 ‘알람 복구’를 누르세요",
	"see_what_it_carries_put": "실린 캐리어를 확인해 ‘스테이션’의 ‘캐리어 위치 기록’에 기록한 뒤 ‘보고가 맞음: 계속’로 해제하세요",
	"look_there_then_put_api": "현장을 확인한 뒤 스테이션에서 ‘기록’을 누르세요",
	"teach_it_post_api_v": "‘티칭’에서 티칭하거나 {0}의 ‘직접 입력’을 쓰세요",
	"teach_it_post_api_v_teaching": "‘티칭’에서 티칭하거나 {0}의 ‘직접 입력’을 쓰세요",
	"align_the_hoist_over_the": "호이스트를 포트 위에 맞춘 뒤 ‘DEST 티칭’ 또는 ‘OFFSET 티칭’을 누르거나, 차량에서 축별로 보내세요",
	"may_stand_at_where_a_pick": "{1}에서 집기(PICKUP)가 실패하여 {0}이(가) 남아 있을 수 있습니다: 확인한 뒤 {2}의 ‘기록’에서 ‘점유’를 기록하세요",
	"see_get": "{0}을(를) 보세요",
	"post_api_v1_teaching_proposals": "제안 {0}에서 스테이션을 적고 ‘지정’을 누르세요",
	"teach_at_a_reference_port": "기준 포트에서 {0}을(를) 티칭하거나 {1}의 ‘직접 입력’을 쓰세요",
	"teach_with_a_vehicle_of": "OFFSET을 아는 차량으로 {0}을(를) 티칭하거나 {1}의 ‘직접 입력’을 쓰세요",
	"delete_api_v1_devices_pin": "먼저 {0}에서 ‘차량 제어로 되돌리기’를 누르세요",
	"see_get_api_v1_operations": "드라이브의 ‘요청 이력’에서 {0}을(를) 보거나 새로 시작하세요",
	"delete_its_jog": "조그 {0}의 버튼을 놓으세요",
	"stop_it_first_post_api": "먼저 {0}에서 ‘정지 / 리셋’을 누르세요",
	"when_it_is_over_post": "상황이 끝나면 ‘플랜트…’에서 해제하세요",
	"use_a_new_for_a": "새 작업에는 새 {0}을(를) 쓰거나 ‘작업’에서 {1}을(를) 확인하세요",
	"if_a_carrier_is_there": "그곳에 캐리어가 있으면 먼저 ‘스테이션’의 ‘캐리어 위치 기록’에 기록하세요",
	"post_api_v1_jobs_abort": "작업 {0}에서 ‘중단’을 누르세요",
	"post_api_v1_jobs_cancel": "작업 {0}에서 ‘취소’를 누르세요",
	"see_get_api_v1_stations": "‘스테이션’에서 처리 가능한 스테이션을 확인하세요",
	"nobody_knows_where_is_put": "{0}의 위치를 모름: ‘스테이션’의 ‘캐리어 위치 기록’에 {1}의 위치를 기록하세요",
	"post_api_v1_vehicles_recover": "{0}에서 ‘알람 복구’를 누르세요",
	"post_api_v1_vehicles_release": "{0}에서 ‘해제’를 누르세요",
	"connect_them_or_post_api": "연결하거나 ‘레일에서 제거됨’ 또는 ‘바코드 위치에 서 있음’으로 해제하세요. 연결되어 보류 중인 차량은 ‘보고가 맞음: 계속’으로 해제하세요",
	"end_what_closes_it_kept": "폐쇄 원인을 없애세요: ‘폐쇄’의 ‘경로가 피하는 곳’에 있습니다",
	"if_it_is_not_so": "사실과 다르면 {0}에서 ‘기록’을 누르세요",
	"release_it_first_post_api": "먼저 ‘플랜트…’에서 비상을 해제하세요",
	"name_another_one_or_have": "다른 것을 지정하거나 ‘레이아웃’에서 버전 {0}을(를) 거부하세요",
	"put_it_back_into_the": "파일에 다시 넣으세요. 레일에서 내린 뒤 {0}을(를) ‘레일에서 제거됨’으로 해제하고 빼세요.",
	"mend_the_receiver_then_patch": "수신 쪽을 고친 뒤 ‘웹훅’에서 웹훅 {0}을(를) 다시 켜세요",
	"get_api_v1_lists_them": "/api/v1/{0}에서 목록을 확인하세요.",
	"get_api_v1_names_its": "/api/v1/{0}에서 모델을 확인하세요.",
	"get_api_v1_says_since": "/api/v1/{0}에서 시작 시각을 확인하세요.",
	"see_get_api_v1": "/api/v1/{0}을(를) 보세요.",
	"see_get_api_v1_2": "/api/v1/{0}을(를) 보세요",
	"the_live_stream_is_at": "페이지가 실시간 스트림을 직접 받습니다.",
	"add_a_user_first_post": "먼저 ‘사용자와 키’에서 사용자를 추가하세요.",
	"get_one_with_get_api": "‘재생’의 ‘사건’에서 저장하세요.",
	"delete_api_v1_keys_name": "키는 ‘사용자와 키’에서 끝냅니다.",
	"wait_for_it_or_post": "기다리거나 ‘레이아웃’에서 버전 {0}을(를) 거부하세요.",
	"reject_what_nobody_wants_any": "‘레이아웃’에서 필요 없는 버전을 거부하세요.",
	"activate_that_one_post_api": "‘레이아웃’에서 버전 {0}을(를) 적용하세요.",
	"its_dest_counts_only_where": "dest는 데이터베이스를 만들 때만 쓰임: 티칭하거나 스테이션의 ‘직접 입력’을 쓰세요",
	"its_dest_counts_only_where_2": "{0}; dest는 데이터베이스를 만들 때만 쓰임: 티칭하거나 스테이션의 ‘직접 입력’을 쓰세요",
	"export_it_first_get_api": "먼저 ‘티칭’에서 {0}을(를) 내보내고, 같은 장소나 기계이면 이름을 유지하세요",
	"back_it_up_first_post": "먼저 드라이브에서 ‘백업’을 누르세요",
	"tell_where_it_is_put": "‘스테이션’의 ‘캐리어 위치 기록’에 위치를 기록하세요",
	"take_it_off_the_rail": "레일에서 내린 뒤 {0}을(를) ‘레일에서 제거됨’으로 해제하세요",
	"patch_api_v1_stations_with": "먼저 {0}의 ‘기록’에서 ‘사용 중지’를 적고, 이후 다시 티칭하세요",
	"look_where_it_stands_then": "위치를 확인한 뒤 ‘보고가 맞음: 계속’로 해제하세요",
	"look_where_it_stands_bring": "위치를 확인하고 읽히는 바코드로 옮긴 뒤 ‘보고가 맞음: 계속’로 해제하세요",
	"look_where_it_stands_release": "위치를 확인하고 바코드가 맞으면 ‘보고가 맞음: 계속’로 해제하세요",
	"release_it_with_verdict_go": "다시 레일에 있으면 ‘보고가 맞음: 계속’로 해제하세요",
	"see_that_the_carrier_stands": "캐리어 위치를 확인한 뒤 ‘보고가 맞음: 계속’로 해제하세요",
	"find_the_carrier_correct_its": "캐리어를 찾아 위치를 고친 뒤 ‘보고가 맞음: 계속’로 해제하세요 (작업은 실패 처리됨)",
	"compare_its_place_load_and": "위치, 적재, 작업을 현장과 비교해 고친 뒤 ‘보고가 맞음: 계속’로 해제하세요",
	"stop_it_then_release_it": "정지시킨 뒤 선 자리에서 ‘보고가 맞음: 계속’로 해제하세요",
	"use_go_on": "‘보고가 맞음: 계속’로 해제하세요",
	"send_stop_first_it_brings": "먼저 ‘정지 (MANT)’를 누르세요. MANT로 바뀝니다",
	"send_stop": "‘정지 (MANT)’를 누르세요",
	"let_a_person_look_at": "사람이 차량을 확인한 뒤 ‘확인함: 원점 복귀가 안전함’을 선택하세요",
	"bring_to_barcode_send_it": "{0}을(를) 바코드 {1}(으)로 옮기세요: ‘이동’, ‘정지 유형’ ‘포트’",
	"bring_it_to_barcode_in": "바코드 {0}(으)로 옮기세요: AUTO에서 ‘이동’(‘정지 유형’ ‘포트’) 후 ‘정지 (MANT)’를 누르세요",
	"send_the_header_x_actor": "오른쪽 위에 이름을 적으세요(‘이름’).",
	"leave_action_out_or_send": "‘정지 유형’에서 ‘정지만’를 고르세요",
	"send_move_to_one_of": "먼저 {0} 중 한 곳으로 ‘이동’하세요",
	"send_move_to_a_tag": "태그로 ‘이동’하거나, 다른 차량을 주행면에서 내리세요(‘레일에서 제거됨’)",
	"send_move_to_it_leads": "{0}(으)로 ‘이동’하세요: 태그를 하나씩 거쳐 갑니다",
	"wait_or_send_move_to": "기다리거나 {0}(으)로 ‘이동’하세요: 갈 수 있는 데까지 갑니다",
	"send_move_with_the_barcode": "바코드를 적고 ‘이동’을 쓰세요",
	"send_move_to_with_action": "먼저 {0}(으)로 ‘이동’하세요(‘정지 유형’: {1})",
	"send_servo_on_search_home": "‘서보 켜기’, ‘원점 탐색’, ‘자동’을 누르거나 ‘알람 복구’를 누르세요",
	"leave_vehicle_out": "차량을 비워 두세요",
	"leave_vehicle_out_only_a": "차량을 비워 두세요: 대기 중인 작업만 차량을 바꿀 수 있습니다",
	"leave_carrier_out": "캐리어를 비워 두세요",
	"has_its_lift_neither_up": "리프트가 상승도 하강도 아님: 기다리거나 ‘리프트 상승’ 또는 ‘리프트 하강’을 누르세요",
	"leave_expires_out_and_open": "‘분’을 비워 두고, 모두 나온 뒤 여세요",
	"look_there_and_enter_it": "현장을 확인해 입력하거나, 확인한 것만 승인하세요",
	"to_take_the_files_put": "파일의 값을 쓰려면 {1}의 ‘직접 입력’을 쓰세요: {3}"
};
var names = {
	"axis_drive_of_the_demo_plant": "데모 플랜트의 축 드라이브",
	"acceleration_time": "가속 시간",
	"from_rest_to_the_maximum_speed": "정지에서 최고 속도까지",
	"deceleration_time": "감속 시간",
	"from_the_maximum_speed_to_rest": "최고 속도에서 정지까지",
	"quick_stop_time": "급정지 시간",
	"s_curve": "S자 곡선",
	"maximum_speed": "최고 속도",
	"minimum_speed": "최저 속도",
	"run_speed": "운전 속도",
	"jog_speed": "조그 속도",
	"home_search_speed": "원점 탐색 속도",
	"home_creep_speed": "원점 저속",
	"home_direction": "원점 방향",
	"cw": "시계 방향",
	"ccw": "반시계 방향",
	"home_offset": "원점 오프셋",
	"right_soft_limit": "우측 소프트 리미트",
	"left_soft_limit": "좌측 소프트 리미트",
	"in_position_window": "위치 도달 범위",
	"mark_sensor_delay": "마크 센서 지연",
	"mark_distance": "마크 거리",
	"index_distance": "인덱스 거리",
	"step_0_position": "스텝 0 위치",
	"step_1_position": "스텝 1 위치",
	"step_2_position": "스텝 2 위치",
	"step_3_position": "스텝 3 위치",
	"step_0_dwell": "스텝 0 정지 시간",
	"step_1_dwell": "스텝 1 정지 시간",
	"step_2_dwell": "스텝 2 정지 시간",
	"step_3_dwell": "스텝 3 정지 시간",
	"motor_rated_current": "모터 정격 전류",
	"overload_limit": "과부하 한계",
	"torque_boost": "토크 부스트",
	"carrier_frequency": "캐리어 주파수",
	"communication_id": "통신 ID",
	"communication_speed": "통신 속도",
	"output_current": "출력 전류",
	"now": "현재",
	"dc_link_voltage": "DC 링크 전압",
	"heat_sink_temperature": "방열판 온도",
	"hours_in_operation": "운전 시간",
	"last_error": "마지막 에러",
	"firmware_version": "펌웨어 버전",
	"merge_of_the_eastern_short_cut": "동쪽 지름길 합류부",
	"merge_of_the_western_short_cut": "서쪽 지름길 합류부",
	"way_into_bay_a": "A 베이 진입로",
	"merge_of_bay_a_s_parking_lane": "A 베이 주차선 합류부",
	"way_out_of_bay_a": "A 베이 출구",
	"way_into_bay_b": "B 베이 진입로",
	"merge_of_bay_b_s_parking_lane": "B 베이 주차선 합류부",
	"way_out_of_bay_b": "B 베이 출구",
	"merge_of_the_hall_s_middle_lane": "AGV 홀 가운데 선로 합류부",
	"lift_of_stocker_stk01": "스토커 STK01 승강축",
	"fork_of_stocker_stk01": "스토커 STK01 포크",
	"turntable_of_sort01": "SORT01 턴테이블",
	"shutter_of_the_clean_room": "클린룸 셔터",
	"east_curve": "동쪽 곡선"
};
// src/rooms.ts
/** In which room, or under which tab, the page shows what a path of the API gives. Pure. */
var ROOM_OF = {
	vehicles: "vehicles",
	jobs: "jobs",
	alarms: "alarms",
	closures: "closures",
	zones: "closures",
	controller: "closures",
	stations: "stations",
	carriers: "stations",
	walks: "walks",
	teaching: "teaching",
	statistics: "statistics",
	history: "playback",
	layout: "layouts",
	users: "access",
	keys: "access",
	audit: "audit",
	webhooks: "webhooks",
	devices: "devices",
	drives: "drives",
	operations: "drives",
	links: "lines",
	events: "events"
};
/** The word of the page for the room of a path's first part; "": there is none. */
var roomOf = (first) => Object.hasOwn(ROOM_OF, first) ? ROOM_OF[first] : "";
// src/particles.ts
/** As the texts write them: after a vowel, after a consonant. */
var FORMS = {
	"이(가)": ["가", "이"],
	"은(는)": ["는", "은"],
	"을(를)": ["를", "을"],
	"과(와)": ["와", "과"],
	"와(과)": ["와", "과"],
	"(으)로": ["로", "으로"],
	"(이)라": ["라", "이라"],
	"(이)나": ["나", "이나"],
	"(이)고": ["고", "이고"],
	"(이)며": ["며", "이며"]
};
var FORM = new RegExp(`(?<=\\S) ?(${Object.keys(FORMS).map((form) => form.replace(/[()]/g, "\\$&")).join("|")})`, "g");
/** What stands in brackets is not read: the particle goes by the word before them. */
var REMARK = /\([^()]*\)$/;
var UNIT = /[0-9] ?(?:mm|cm|m|km|s|ms|h|mm\/s|m\/s|MB|GB|%)$/;
var DIGITS = {
	"0": "consonant",
	"1": "l",
	"3": "consonant",
	"6": "consonant",
	"7": "l",
	"8": "l"
};
/** Letters whose Korean names end in a consonant: 엘, 엠, 엔, 알. */
var LETTERS$1 = {
	L: "l",
	M: "consonant",
	N: "consonant",
	R: "l"
};
var OPEN$1 = /* @__PURE__ */ new Set("aiouywrdgfvszxh");
/** Ends of words that are read as words; of others (port, map, node) letters alone do not tell. */
var SPOKEN = {
	l: "l",
	m: "consonant",
	n: "consonant"
};
/** Capitals of so many letters, or without a vowel among them, are read letter by letter. */
var ABBREVIATION = 3;
/** A text with the particle that fits in each place where it can be told; elsewhere 이(가) stays as it is. */
function settled(text) {
	let done = "";
	let at = 0;
	for (const form of text.matchAll(FORM)) {
		const before = done + text.slice(at, form.index);
		const sound = soundOf(before);
		if (sound === null) continue;
		done = before + chosen(form[1] ?? "", sound);
		at = form.index + form[0].length;
	}
	return done + text.slice(at);
}
function chosen(form, sound) {
	const [open, closed] = FORMS[form] ?? [form, form];
	return sound === "vowel" || sound === "l" && form === "(으)로" ? open : closed;
}
/** How a text ends, read aloud in Korean; null: its letters do not tell. */
function soundOf(given) {
	let text = given.replace(/['"’”」`]+$/, "");
	for (;;) {
		const shorter = text.replace(REMARK, "").replace(/['"’”」` ]+$/, "");
		if (shorter === text || !shorter) break;
		text = shorter;
	}
	if (UNIT.test(text)) return "vowel";
	const last = text.slice(-1);
	if (last >= "가" && last <= "힣") return ofSyllable(last);
	if (/[0-9]/.test(last)) return DIGITS[last] ?? "vowel";
	const word = /[A-Za-z]*$/.exec(text)?.[0] ?? "";
	return word ? ofLetters(word) : null;
}
function ofSyllable(letter) {
	const final = (letter.charCodeAt(0) - 44032) % 28;
	return final === 0 ? "vowel" : final === 8 ? "l" : "consonant";
}
function ofLetters(given) {
	const capitals = given === given.toUpperCase();
	const byName = LETTERS$1[given.slice(-1).toUpperCase()] ?? "vowel";
	if (given.length === 1 || capitals && (given.length <= ABBREVIATION || !/[AEIOUY]/.test(given))) return byName;
	const word = given.toLowerCase();
	const last = word.slice(-1);
	const spoken = word.endsWith("ng") ? "consonant" : OPEN$1.has(last) ? "vowel" : SPOKEN[last] ?? null;
	return capitals && spoken !== byName ? null : spoken;
}
// src/sayings.ts
/** Sentences within sentences are translated too, so deep. */
var DEPTH = 4;
var KEPT$4 = 2e3;
var Sayings = class {
	list;
	known = /* @__PURE__ */ new Map();
	/** What a sentence has in it that comes out otherwise; null: any may. */
	marks;
	/** Two catalogues of the same keys; {0}, {1} … are slots. `only`: the keys for which the two differ, if few. */
	constructor(from, to, only) {
		this.marks = only?.map((key) => fixedOf(from[key] ?? "")) ?? null;
		this.list = Object.entries(from).map(([key, text]) => ({
			fixed: fixedOf(text),
			pattern: patternOf(text),
			other: to[key] ?? text,
			weight: text.replace(/\{\d\}/g, "").length
		}));
		this.list.sort((a, b) => b.weight - a.weight);
	}
	translate(sentence) {
		if (!sentence || this.marks?.every((mark) => !sentence.includes(mark))) return sentence;
		const known = this.known.get(sentence);
		if (known !== void 0) return known;
		const found = this.retold(sentence, DEPTH);
		if (this.known.size >= KEPT$4) this.known.clear();
		this.known.set(sentence, found);
		return found;
	}
	retold(sentence, depth) {
		for (const { fixed, pattern, other } of this.list) {
			const match = sentence.includes(fixed) ? pattern.exec(sentence) : null;
			if (!match) continue;
			return other.replace(/\{(\d)\}/g, (_, slot) => {
				const part = match.groups?.[`s${slot}`] ?? "";
				return depth > 0 && part.includes(" ") ? this.retold(part, depth - 1) : part;
			});
		}
		const end = sentence.indexOf("; ");
		if (end < 0 || depth === 0) return sentence;
		return `${this.retold(sentence.slice(0, end), depth - 1)}; ${this.retold(sentence.slice(end + 2), depth - 1)}`;
	}
};
var fixedOf = (text) => text.split(/\{\d\}/).reduce((longest, part) => part.length > longest.length ? part : longest, "");
/** What stands first is a name, or several: a clause within a sentence is none by itself. */
function patternOf(text) {
	const parts = text.split(/(\{\d\})/).filter(Boolean).map((part, i) => {
		const slot = /^\{(\d)\}$/.exec(part);
		return slot ? `(?<s${slot[1]}>${i === 0 ? "\\S+?(?: \\(for \\S+?\\))?(?:, \\S+?)*?" : ".+?"})` : part.replace(/[.*+?^${}()|[\]\\]/g, "\\$&");
	});
	return new RegExp(`^${parts.join("")}$`, "s");
}
// src/texts.ts
/**
* Every word of the page, in both languages, from the catalogue that the API and the command line speak from as well
* (app/texts). What the server says in sentences is translated by the catalogue's sayings where it has them.
*/
var KEPT$3 = "hoistway.language";
var kept$4 = localStorage.getItem(KEPT$3);
var language = y$1(kept$4 === "en" || kept$4 === "ko" ? kept$4 : navigator.language.startsWith("ko") ? "ko" : "en");
/** What helps is said by the server in words of its API; where that names a call, the page names its button or room (`pages`). */
var english = new Sayings(sayings$1, {
	...sayings$1,
	...pages$1
}, Object.keys(pages$1));
var under = (section, words) => Object.fromEntries(Object.entries(words).map(([key, text]) => [`${section} ${key}`, text]));
var korean = new Sayings({
	...sayings$1,
	...under("remedy", remedies$1),
	...under("name", names$1)
}, {
	...sayings,
	...pages,
	...under("remedy", remedies),
	...under("name", names)
});
function speak(next) {
	localStorage.setItem(KEPT$3, next);
	language.value = next;
	document.documentElement.lang = next;
}
/** A word or sentence; {0}, {1} … are replaced. */
function t(word, ...values) {
	const text = (language.value === "ko" ? page : page$1)[word];
	const filled = values.reduce((sentence, value, i) => sentence.replace(`{${i}}`, String(value)), text);
	return language.value === "ko" && values.length > 0 ? settled(filled) : filled;
}
/** The server's word for a state, translated if we know it. */
function said$1(word) {
	return Object.hasOwn(page$1, word) ? t(word) : word.replaceAll("_", " ");
}
/** A sentence of the server, translated as far as the catalogue knows it, with the page's names for what it says to call. */
function tell(sentence) {
	if (language.value === "ko" && Object.hasOwn(page, sentence)) return said$1(sentence);
	if (language.value === "ko") return settled(withRooms(korean.translate(sentence)));
	return withRooms(english.translate(sentence));
}
var CALL = /(?:\b(?:GET|POST|PUT|PATCH|DELETE) )?\/api\/v1\/([a-z]+)(?:\/[\w/:-]+)?/g;
/** A path of the API that a sentence has filled in, as the room where that is to be seen. */
function withRooms(sentence) {
	if (!sentence.includes("/api/v1/")) return sentence;
	return sentence.replace(CALL, (path, first) => {
		const word = roomOf(first);
		return word ? t("the_room", t(word)) : path;
	});
}
/** An event of SEMI E82 in words: VehicleAcquireStarted -> Vehicle acquire started. */
function happening(event) {
	return (language.value === "ko" ? events : events$1)[event] ?? event.replace(/([a-z])([A-Z])/g, "$1 $2");
}
// src/access.ts
/** Who is at the page and which calls they may make: the server says both, and when they have to say so again. */
var KEPT$2 = "hoistway.session";
/** What a tab and those that were made of it have in common: a name for the log-in. */
var FAMILY = "hoistway.family";
/** Looked so often whether the token is to be renewed, ms. */
var LOOK = 15e3;
/** A server that does not answer is asked again after so long, ms. */
var LATER = 2e3;
var me = y$1(null);
/** Whether somebody has to say who they are before the page can go on. */
var asked$2 = y$1(false);
/** Rises whenever it becomes known who is there: what was refused before is read again. */
var round$2 = y$1(0);
/** Why a button that was pressed does nothing; whether somebody else could press it. */
var barred$1 = y$1(null);
var rulings = y$1(/* @__PURE__ */ new Map());
var session = y$1(kept$3());
function kept$3() {
	try {
		return JSON.parse(sessionStorage.getItem(KEPT$2) ?? "null");
	} catch {
		return null;
	}
}
function keep(next) {
	session.value = next;
	if (next) sessionStorage.setItem(KEPT$2, JSON.stringify(next));
	else sessionStorage.removeItem(KEPT$2);
}
var others = new BroadcastChannel(KEPT$2);
var family = () => sessionStorage.getItem(FAMILY) ?? "";
function hear({ data }) {
	if (!family() || data.family !== family()) return;
	if (data.token === null) leave$1();
	else {
		useKey$1(data.token);
		keep(data.kept);
	}
}
/** All roles there are: each may at least look. */
var allRoles = O(() => {
	return [...rulings.value.values()].map(({ roles }) => roles).reduce((longest, roles) => roles.length > longest.length ? roles : longest, []);
});
/** Roles in words, for people. */
var inWords$2 = (roles) => roles.map((role) => said$1(`role_${role}`)).join(", ");
/** Why who is here may not make a call; "" where they may, or where the server is to say so itself. */
function refusal(call) {
	const who = me.value;
	const ruling = rulings.value.get(call);
	if (!who || who.open || !ruling || ruling.allowed) return "";
	return t("needs_role", inWords$2(ruling.roles), who.name ?? "", inWords$2(who.roles) || t("none"));
}
/** Whether the people who work here are named by themselves: nobody logs in, or a machine's key speaks for somebody. */
var namesItself = O(() => me.value === null || me.value.open || !me.value.person);
/** Ask the server who this is and what they may. `anew`: somebody has just said who they are. */
async function learn(anew = false) {
	const [who, calls] = await Promise.all([get("/session"), get("/session/calls")]);
	if (JSON.stringify(who) === JSON.stringify(me.value) && !anew) return;
	rulings.value = new Map(calls.items.map((ruling) => [ruling.call, ruling]));
	me.value = who;
	barred$1.value = null;
	round$2.value++;
}
function take({ token, expires, until }) {
	const [now, end] = [serverNow(), Date.parse(expires)];
	const kept = {
		renew: now + (end - now) / 2,
		expires: end,
		until: Date.parse(until)
	};
	useKey$1(token);
	keep(kept);
	if (family()) others.postMessage({
		family: family(),
		token,
		kept
	});
}
/** Somebody has said who they are: what waited for that goes on. */
async function entered() {
	await learn(true);
	asked$2.value = false;
	letGo();
}
/** Log in with a password. Raises Refused. */
async function logIn(name, password) {
	const given = await post("/session", {
		name,
		password
	});
	sessionStorage.setItem(FAMILY, freshKey());
	take(given);
	await entered();
}
/** Use a machine's key. Raises Refused. */
async function useKey(key) {
	const before = held();
	useKey$1(key);
	try {
		await entered();
	} catch (failure) {
		useKey$1(before);
		throw failure;
	}
	keep(null);
	sessionStorage.setItem(FAMILY, freshKey());
}
/** Log out, here and in the tabs that were duplicated. */
async function logOut() {
	if (family()) others.postMessage({
		family: family(),
		token: null
	});
	await leave$1();
}
/** End the session, and begin with an empty page: nothing of what was shown stays. */
async function leave$1() {
	if (me.value?.person) await call("DELETE", "/session").catch(() => void 0);
	forget();
	location.reload();
}
function forget() {
	useKey$1("");
	sessionStorage.removeItem(FAMILY);
	keep(null);
}
async function renew() {
	const now = session.value;
	if (!now || asked$2.value || serverNow() < now.renew) return;
	keep({
		...now,
		renew: serverNow() + LOOK
	});
	try {
		take(await post("/session/renew"));
	} catch {}
}
/** Ask whenever the server wants to know; `go` begins, and goes on after each log-in; `gone`: it does not answer. */
function begin$6(go, gone) {
	onKeyWanted(() => asked$2.value = true);
	onForbidden(() => void learn().catch(() => void 0));
	others.addEventListener("message", hear);
	window.setInterval(() => void renew(), LOOK);
	if (session.value && session.value.expires < serverNow()) forget();
	if (!held()) holdBack();
	const first = async () => {
		try {
			if (!held() && (await get("/session/required")).required) {
				asked$2.value = true;
				return;
			}
			letGo();
			await learn();
		} catch (error) {
			if (error instanceof Refused && error.status === 401) return;
			gone();
			window.setTimeout(() => void first(), LATER);
		}
	};
	first();
	renew();
	let before = round$2.value;
	round$2.subscribe((now) => {
		if (now !== before) go();
		before = now;
	});
}
// src/alarms.ts
function wrongs({ controller, vehicles, devices, drives }) {
	return [
		...controller ? ofController(controller) : [],
		...[...vehicles].flatMap(ofVehicle),
		...[...devices].flatMap(ofDevice),
		...[...drives].flatMap(ofDrive)
	].sort((a, b) => Number(b.grave) - Number(a.grave) || (b.since ?? "").localeCompare(a.since ?? ""));
}
function ofController(controller) {
	const of = (key, cause, since = null) => ({
		key: `controller ${key}`,
		source: controller.plant,
		kind: "controller",
		grave: true,
		cause,
		remedy: "",
		since
	});
	return [
		...controller.trouble ? [of("trouble", controller.trouble)] : [],
		...controller.emergencies.map((words) => of(words, words)),
		...controller.circles.map((words) => of(words, words))
	];
}
function ofVehicle(vehicle) {
	const { hold, lockout, link } = vehicle;
	const of = (grave, cause, remedy, since) => ({
		key: `vehicle ${vehicle.id}`,
		source: vehicle.id,
		kind: "vehicle",
		grave,
		cause,
		remedy,
		since
	});
	if (vehicle.oper === "alarm") return [of(true, [vehicle.code ? `0x${vehicle.code.toString(16).toUpperCase().padStart(4, "0")} ${vehicle.code_name}`.trim() : "", hold?.reason].filter(Boolean).join(": ") || "alarm", hold?.remedy ?? "", hold?.since ?? null)];
	if (lockout) return [of(false, `locked out by ${lockout.owner}: ${lockout.reason}`, "", lockout.since)];
	if (hold) return [of(false, hold.reason, hold.remedy, hold.since)];
	return link.up || vehicle.activity === "off_rail" ? [] : [of(false, `it is not connected: ${link.reason}`, "", link.since)];
}
function ofDevice(device) {
	const cause = device.alarm || device.contradiction;
	if (!cause) return [];
	return [{
		key: `device ${device.id}`,
		source: device.id,
		kind: "device",
		grave: Boolean(device.alarm),
		cause,
		remedy: device.remedy,
		since: device.since
	}];
}
function ofDrive(drive) {
	const of = (grave, cause) => [{
		key: `drive ${drive.id}`,
		source: drive.id,
		kind: "drive",
		grave,
		cause,
		remedy: drive.remedy,
		since: drive.seen
	}];
	if (drive.online && drive.mode === "error") return of(true, drive.error || drive.meaning);
	return drive.online === false ? of(false, drive.reason) : [];
}
// src/ends.ts
var worldOfKind = (kind) => kind === "agv_buffer" ? "agv" : "hoist";
/** Who serves a station, or what a vehicle is; null: there is none of that name. */
function worldOf(layout, id) {
	const station = layout?.stations.find((one) => one.id === id);
	if (station) return worldOfKind(station.kind);
	const vehicle = layout?.vehicles.find((one) => one.id === id);
	return vehicle ? vehicle.kind === "agv" ? "agv" : "hoist" : null;
}
/** Whether a job can go from one to the other; what is not chosen yet forbids nothing. */
function joins(layout, source, destination) {
	const [from, to] = [worldOf(layout, source), worldOf(layout, destination)];
	return from === null || to === null || from === to;
}
// src/live.ts
/** Takes frames in order; tells when a number is missing, or when the server has begun another history. */
var Stream = class {
	sink;
	seq = null;
	/** Number of the last event taken, null before the first snapshot. */
	lastEvent = null;
	constructor(sink) {
		this.sink = sink;
	}
	/** A new connection starts with its own snapshot and numbers. */
	restart() {
		this.seq = null;
	}
	/** Takes a message; returns what to do about it. */
	take(text) {
		const frame = JSON.parse(text);
		switch (frame.type) {
			case "snapshot": return this.snapshot(frame);
			case "change": return this.change(frame);
			case "event":
				this.events(frame.events ?? []);
				return null;
			case "resync":
				this.seq = null;
				return null;
			case "error":
				this.sink.problem(frame.problem?.detail ?? "The server refused the live stream.");
				return null;
			default: return null;
		}
	}
	snapshot(frame) {
		const last = frame.last_event ?? 0;
		const anew = this.lastEvent !== null && last < this.lastEvent;
		if (anew) this.sink.forget();
		this.seq = frame.seq ?? 0;
		this.sink.snapshot(frame.objects ?? {}, last);
		if (anew || this.lastEvent === null) this.lastEvent = last;
		return anew ? "reconnect" : null;
	}
	change(frame) {
		if (this.seq === null) return null;
		if (frame.seq !== this.seq + 1) {
			this.seq = null;
			return { say: JSON.stringify({ resync: true }) };
		}
		this.seq = frame.seq;
		for (const { topic, key, value } of frame.changes ?? []) this.sink.change(topic, key, value);
		this.sink.changed();
		return null;
	}
	events(events) {
		const news = events.filter((event) => this.lastEvent === null || event.seq > this.lastEvent);
		const last = news.at(-1);
		if (last === void 0) return;
		this.lastEvent = last.seq;
		this.sink.events(news);
	}
};
var PAUSES = [
	300,
	1e3,
	2e3,
	4e3
];
/** Silence on a quiet plant is normal; after this many ms we ask the server whether it is still there. */
var SILENCE = 1e4;
/** Keeps one stream open, for ever. */
var Watcher = class {
	stream;
	door;
	socket = null;
	failures = 0;
	heard = Date.now();
	timer = 0;
	constructor(stream, door) {
		this.stream = stream;
		this.door = door;
		window.setInterval(() => void this.listen(), SILENCE / 2);
		window.addEventListener("online", () => this.again(0));
	}
	async open() {
		window.clearTimeout(this.timer);
		if (this.socket) return;
		let address = null;
		try {
			address = await this.door.address(this.stream.lastEvent);
		} catch {
			this.again();
			return;
		}
		if (address === null || this.socket) return;
		const socket = new WebSocket(address);
		this.socket = socket;
		this.stream.restart();
		socket.onmessage = (message) => this.take(socket, String(message.data));
		socket.onclose = () => this.closed(socket);
	}
	take(socket, text) {
		if (socket !== this.socket) return;
		this.heard = Date.now();
		this.failures = 0;
		const answer = this.stream.take(text);
		if (answer === "reconnect") {
			this.socket = null;
			socket.close();
			this.again(0);
			return;
		}
		if (answer) socket.send(answer.say);
		this.door.state("live");
	}
	closed(socket) {
		if (socket !== this.socket) return;
		this.socket = null;
		this.again();
	}
	again(pause) {
		if (this.socket) return;
		this.door.state("lost");
		window.clearTimeout(this.timer);
		const wait = pause ?? PAUSES[Math.min(this.failures++, PAUSES.length - 1)];
		this.timer = window.setTimeout(() => void this.open(), wait);
	}
	async listen() {
		const socket = this.socket;
		if (!socket || socket.readyState !== WebSocket.OPEN || Date.now() - this.heard < SILENCE) return;
		if (await this.door.alive()) this.heard = Date.now();
		else if (socket === this.socket) {
			this.socket = null;
			socket.close();
			this.again();
		}
	}
};
// src/past/then.ts
var LINK = {
	up: true,
	since: "",
	reason: "",
	frames_in: 0,
	frames_out: 0,
	garbled: 0,
	resends: 0,
	duplicates: 0,
	round_trip_ms: null
};
var BLANK = {
	id: "",
	dev_id: 0,
	dialect: "",
	address: "",
	state: "",
	activity: "",
	service: "",
	link: LINK,
	mode: null,
	oper: null,
	code: null,
	code_name: "",
	loaded: null,
	carrier: null,
	barcode: null,
	dist: null,
	seq: null,
	status1: null,
	status2: null,
	bits: [],
	job: null,
	goal: null,
	waiting: "",
	waits_for: null,
	granted: [],
	covered: [],
	hold: null,
	lockout: null,
	seen: null,
	parked: false
};
var GONE = {
	...LINK,
	up: false
};
/** A vehicle as it was recorded. */
function ofThen(id, now) {
	return {
		...BLANK,
		...now,
		id,
		link: now["activity"] === "absent" ? GONE : LINK
	};
}
/** One that was shown, with what has changed of it: made many thousand times a second. */
function changedOf(before, now) {
	return {
		...before,
		...now,
		link: (now["activity"] ?? before.activity) === "absent" ? GONE : LINK
	};
}
// src/shows.ts
/** As custom properties of the style sheet, which has them for each theme. */
var LOOKS = {
	idle: "var(--look-idle)",
	moving: "var(--look-moving)",
	waiting: "var(--look-waiting)",
	handling: "var(--look-handling)",
	charging: "var(--look-charging)",
	held: "var(--look-held)",
	alarm: "var(--look-alarm)",
	gone: "var(--look-gone)"
};
/** Beside a name, for whom colours say little: each look has a sign of its own, and only who is idle has none. */
var SIGNS = {
	idle: "",
	moving: "›",
	waiting: "…",
	handling: "↕",
	charging: "↯",
	held: "‖",
	alarm: "!",
	gone: "?"
};
var LOOK_OF = {
	idle: "idle",
	moving: "moving",
	waiting: "waiting",
	busy: "waiting",
	paused: "waiting",
	acquiring: "handling",
	depositing: "handling",
	charging: "charging",
	settling: "held",
	held: "held",
	locked_out: "held",
	recovering: "held",
	alarm: "alarm",
	absent: "gone",
	off_rail: "gone"
};
function lookOf(vehicle) {
	if (vehicle.oper === "alarm" && vehicle.activity !== "absent") return "alarm";
	const look = LOOK_OF[vehicle.activity] ?? "idle";
	return look === "idle" && !vehicle.link.up ? "gone" : look;
}
var DEVICE_LOOKS = {
	open: "var(--device-open)",
	closed: "var(--device-closed)",
	cart: "var(--device-cart)",
	no_cart: "var(--device-no_cart)",
	charging: "var(--device-charging)",
	free: "var(--device-free)",
	busy: "var(--device-busy)",
	unknown: "var(--device-unknown)",
	error: "var(--device-error)",
	silent: "var(--device-silent)"
};
/** How a door or buffer looks: what it said counts only while it is heard. A charger says nothing itself. */
function lookOfDevice(device, charging = false) {
	if (device?.kind === "charger") return charging || device.vehicles?.length ? "charging" : "free";
	if (!device?.fresh) return "silent";
	const state = device.state ?? "unknown";
	return Object.hasOwn(DEVICE_LOOKS, state) ? state : "unknown";
}
var MODES = {
	parameter_select: 0,
	parameter_value: 0,
	monitoring: 0,
	jog: 0,
	error: 0
};
/** The sign beside a name for what colour alone does not say: an alarm, or that nobody knows. */
function signOfDevice(device, look) {
	if (device?.alarm || look === "error") return "!";
	return look === "unknown" || look === "silent" ? "?" : look === "busy" ? "…" : "";
}
/** Its colour, or that of an alarm. */
function colourOfDevice(device, look) {
	return DEVICE_LOOKS[device?.alarm ? "error" : look];
}
/** What a drive does, in one word: that of its mode, or why there is none. */
function lookOfDrive(drive) {
	if (drive.online === null) return {
		word: "not_heard",
		tone: "wait"
	};
	if (!drive.online) return {
		word: "offline",
		tone: "bad"
	};
	if (drive.mode === null) return {
		word: "online",
		tone: "calm"
	};
	const tone = drive.mode === "error" ? "bad" : drive.mode === "jog" ? "go" : drive.mode === "monitoring" ? "good" : "calm";
	return {
		word: Object.hasOwn(MODES, drive.mode) ? drive.mode : "online",
		tone
	};
}
/** A distance in hundredths, as people read it. */
function hundredths(distance) {
	return (distance / 100).toFixed(2);
}
var TONES$2 = {
	queued: "calm",
	waiting: "wait",
	transferring: "go",
	paused: "wait",
	cancelling: "wait",
	aborting: "wait",
	completed: "good",
	failed: "bad",
	cancelled: "calm",
	aborted: "bad"
};
/** 7 s, 3:05, 1:02:10, 3 d. */
function span(ms) {
	const s = Math.max(0, Math.floor(ms / 1e3));
	const two = (n) => String(n).padStart(2, "0");
	if (s < 60) return `${s} s`;
	if (s < 3600) return `${Math.floor(s / 60)}:${two(s % 60)}`;
	if (s < 86400) return `${Math.floor(s / 3600)}:${two(Math.floor(s / 60) % 60)}:${two(s % 60)}`;
	return `${Math.floor(s / 86400)} d`;
}
function elapsed(job, now) {
	return span((job.ended ? Date.parse(job.ended) : now) - Date.parse(job.created));
}
/** Time of day at this place. */
/** Day and time of day, for what may lie long ago. */
function moment$1(iso) {
	const at = new Date(iso);
	return Number.isNaN(at.getTime()) ? "" : `${at.toLocaleDateString("sv-SE")} ${clock(iso)}`;
}
function clock(iso) {
	const at = new Date(iso);
	return Number.isNaN(at.getTime()) ? "" : at.toLocaleTimeString("en-GB", { hour12: false });
}
// src/natural.ts
/** Compares names as people do: V2 before V10. */
var NATURAL = new Intl.Collator(void 0, { numeric: true });
// src/grid.ts
/** Things by where they are, in squares: whoever looks for neighbours need not look at all. Pure. */
var CELL$1 = 5e3;
var Grid = class {
	cells = /* @__PURE__ */ new Map();
	put(thing) {
		const key = keyOf$3(Math.floor(thing.x / CELL$1), Math.floor(thing.y / CELL$1));
		const there = this.cells.get(key);
		if (there) there.push(thing);
		else this.cells.set(key, [thing]);
	}
	/** All within a distance to either side, and some more. */
	*around(x, y, reach) {
		const to = (value) => Math.floor(value / CELL$1);
		for (let i = to(x - reach); i <= to(x + reach); i++) for (let j = to(y - reach); j <= to(y + reach); j++) yield* this.cells.get(keyOf$3(i, j)) ?? [];
	}
};
/** One number for two: fabs are a few hundred squares wide. */
var keyOf$3 = (i, j) => (i + 32768) * 65536 + (j + 32768);
// src/track.ts
/** The track as drawn: edges as curves, places along them, and the way between two barcodes. Pure. */
var STEPS$1 = 8;
var minus = (a, b) => ({
	x: a.x - b.x,
	y: a.y - b.y
});
var unit = (v) => {
	const size = Math.hypot(v.x, v.y) || 1;
	return {
		x: v.x / size,
		y: v.y / size
	};
};
var dot = (a, b) => a.x * b.x + a.y * b.y;
var Track = class {
	points = /* @__PURE__ */ new Map();
	ways = /* @__PURE__ */ new Map();
	next = /* @__PURE__ */ new Map();
	before = /* @__PURE__ */ new Map();
	/** Barcodes on the floor: tape of AGVs, and all that hangs together with it. */
	floor;
	box;
	/** Barcodes by where they are. */
	grid = new Grid();
	from = /* @__PURE__ */ new Map();
	constructor(layout) {
		for (const { barcode, x, y, park } of layout.points) {
			this.points.set(barcode, {
				x,
				y,
				park
			});
			this.grid.put({
				x,
				y
			});
		}
		for (const edge of layout.edges) {
			if (!this.points.has(edge.start) || !this.points.has(edge.end)) continue;
			push(this.next, edge.start, edge);
			push(this.before, edge.end, edge);
		}
		for (const edges of this.next.values()) for (const edge of edges) {
			const way = this.draw(edge);
			this.ways.set(keyOf$2(edge), way);
			push(this.from, edge.start, way);
		}
		this.floor = this.connected([...layout.stations.filter((station) => station.kind === "agv_buffer").map((station) => station.barcode), ...layout.chargers.map((charger) => charger.barcode)]);
		const xs = layout.points.map((p) => p.x);
		const ys = layout.points.map((p) => p.y);
		this.box = {
			x0: least(xs, Math.min),
			x1: least(xs, Math.max),
			y0: least(ys, Math.min),
			y1: least(ys, Math.max)
		};
	}
	way(start, end) {
		return this.from.get(start)?.find((way) => way.edge.end === end);
	}
	/** Whether the same piece is driven the other way, too. */
	twoWay(edge) {
		return this.way(edge.end, edge.start) !== void 0;
	}
	/** Place at `mm` of travel along an edge. */
	along(way, mm) {
		const total = way.at.at(-1) ?? 0;
		const want = Math.min(Math.max(mm / way.edge.length, 0), 1) * total;
		let i = 1;
		while (i < way.at.length - 1 && (way.at[i] ?? 0) < want) i++;
		const a = way.pts[i - 1];
		const b = way.pts[i];
		const from = way.at[i - 1] ?? 0;
		const f = (want - from) / ((way.at[i] ?? 0) - from || 1);
		const angle = Math.atan2(b.y - a.y, b.x - a.x);
		return {
			x: a.x + (b.x - a.x) * f,
			y: a.y + (b.y - a.y) * f,
			angle
		};
	}
	/** Place of a barcode, heading as one that has arrived there. */
	spot(barcode) {
		const point = this.points.get(barcode);
		if (!point) return void 0;
		const tangent = this.tangent(barcode, this.before.get(barcode)?.[0] ?? this.next.get(barcode)?.[0]);
		return {
			x: point.x,
			y: point.y,
			angle: Math.atan2(tangent.y, tangent.x)
		};
	}
	/** Barcodes from `start` to `end` by the fewest edges, both included; undefined if more than `limit` edges. */
	path(start, end, limit = 24) {
		if (start === end) return [start];
		const from = /* @__PURE__ */ new Map([[start, ""]]);
		let edge = [start];
		for (let depth = 0; depth < limit && edge.length > 0; depth++) {
			const further = [];
			for (const here of edge) for (const step of this.next.get(here) ?? []) {
				if (from.has(step.end)) continue;
				from.set(step.end, here);
				if (step.end === end) return trace(from, end);
				further.push(step.end);
			}
			edge = further;
		}
	}
	/** All barcodes that hang together with these, whichever way the track is driven. */
	connected(starts) {
		const found = new Set(starts.filter((start) => this.points.has(start)));
		for (const here of found) {
			for (const edge of this.next.get(here) ?? []) found.add(edge.end);
			for (const edge of this.before.get(here) ?? []) found.add(edge.start);
		}
		return found;
	}
	chord(edge) {
		return minus(this.points.get(edge.end), this.points.get(edge.start));
	}
	/** Direction at a barcode for an edge that ends or starts there: that of straight track if there is any, else of the arc. */
	tangent(barcode, own) {
		if (!own) return {
			x: 1,
			y: 0
		};
		const mine = this.chord(own);
		const ins = this.before.get(barcode) ?? [];
		const outs = this.next.get(barcode) ?? [];
		const others = own.end === barcode ? outs : ins;
		const best = (edges) => edges.toSorted((a, b) => dot(unit(this.chord(b)), unit(mine)) - dot(unit(this.chord(a)), unit(mine)))[0];
		const straight = best([...ins, ...outs].filter((edge) => !edge.curve && edge !== own));
		if (!own.curve) return unit(mine);
		if (straight && dot(unit(this.chord(straight)), unit(mine)) > 0) return unit(this.chord(straight));
		const other = best(others);
		if (!other) return unit(mine);
		const theirs = this.chord(other);
		const [l1, l2] = [Math.hypot(mine.x, mine.y) || 1, Math.hypot(theirs.x, theirs.y) || 1];
		return unit({
			x: mine.x / l1 / l1 + theirs.x / l2 / l2,
			y: mine.y / l1 / l1 + theirs.y / l2 / l2
		});
	}
	draw(edge) {
		const a = this.points.get(edge.start);
		const b = this.points.get(edge.end);
		const pts = edge.curve ? arc(a, b, this.tangent(edge.start, edge), this.tangent(edge.end, edge)) : [a, b];
		const at = [0];
		for (let i = 1; i < pts.length; i++) {
			const step = minus(pts[i], pts[i - 1]);
			at.push((at[i - 1] ?? 0) + Math.hypot(step.x, step.y));
		}
		const [xs, ys] = [pts.map((p) => p.x), pts.map((p) => p.y)];
		return {
			edge,
			pts,
			at,
			box: {
				x0: Math.min(...xs),
				x1: Math.max(...xs),
				y0: Math.min(...ys),
				y1: Math.max(...ys)
			}
		};
	}
};
/** A cubic with these directions at its ends, as near to an arc of a circle as a cubic gets. */
function arc(a, b, ta, tb) {
	const chord = Math.hypot(b.x - a.x, b.y - a.y);
	const turn = Math.acos(Math.min(1, Math.max(-1, dot(ta, tb))));
	const reach = turn < .01 ? chord / 3 : chord * (2 / 3) * Math.tan(turn / 4) / Math.sin(turn / 2);
	const c1 = {
		x: a.x + ta.x * reach,
		y: a.y + ta.y * reach
	};
	const c2 = {
		x: b.x - tb.x * reach,
		y: b.y - tb.y * reach
	};
	return Array.from({ length: 9 }, (_, i) => {
		const t = i / STEPS$1;
		const u = 1 - t;
		const [k0, k1, k2, k3] = [
			u * u * u,
			3 * u * u * t,
			3 * u * t * t,
			t * t * t
		];
		return {
			x: k0 * a.x + k1 * c1.x + k2 * c2.x + k3 * b.x,
			y: k0 * a.y + k1 * c1.y + k2 * c2.y + k3 * b.y
		};
	});
}
function keyOf$2(edge) {
	return `${edge.start}>${edge.end}`;
}
function trace(from, end) {
	const path = [end];
	for (let at = from.get(end); at; at = from.get(at)) path.push(at);
	return path.reverse();
}
function push(map, key, value) {
	const list = map.get(key);
	if (list) list.push(value);
	else map.set(key, [value]);
}
function least(values, pick) {
	return values.length ? values.reduce((a, b) => pick(a, b)) : 0;
}
// src/store.ts
/** What the page knows, and how it comes to know it. Objects live in plain maps; a signal per topic says that they changed. */
var EVENTS_SHOWN = 200;
var ENDED_SHOWN = 100;
var TOPICS = "controller,vehicles,jobs,stations,carriers,devices,drives,closures,teaching,alarms,walks,events";
var ENDED = /* @__PURE__ */ new Set([
	"completed",
	"failed",
	"cancelled",
	"aborted"
]);
var layout = y$1(null);
var track = O(() => layout.value ? new Track(layout.value) : null);
var link = y$1("connecting");
/** When the controller was heard last, ms; 0: it has told nothing yet. */
var heardAt = y$1(0);
/** Rises with each connection: what was asked for in vain is read again. */
var connections = y$1(0);
var selected = y$1(null);
var notice = y$1("");
/** Rises once a second, for whatever shows an age. */
var tick = y$1(0);
var happenings = y$1([]);
/** Source and destination of the order being written: the map and the panels fill them too. */
var order = {
	source: y$1(""),
	destination: y$1(""),
	carrier: y$1("")
};
var vehicles = /* @__PURE__ */ new Map();
var jobs = /* @__PURE__ */ new Map();
var stations = /* @__PURE__ */ new Map();
var carriers = /* @__PURE__ */ new Map();
var devices = /* @__PURE__ */ new Map();
var drives = /* @__PURE__ */ new Map();
var closures = /* @__PURE__ */ new Map();
var alarms = /* @__PURE__ */ new Map();
/** Proposals and sessions of teaching; their details are asked for. */
var teaching = /* @__PURE__ */ new Map();
var walks = /* @__PURE__ */ new Map();
var controllers = /* @__PURE__ */ new Map();
var ended = /* @__PURE__ */ new Map();
var maps = {
	controller: controllers,
	vehicles,
	jobs,
	stations,
	carriers,
	devices,
	drives,
	closures,
	teaching,
	alarms,
	walks
};
var changes = {
	controller: y$1(0),
	vehicles: y$1(0),
	jobs: y$1(0),
	stations: y$1(0),
	carriers: y$1(0),
	devices: y$1(0),
	drives: y$1(0),
	closures: y$1(0),
	teaching: y$1(0),
	alarms: y$1(0),
	walks: y$1(0)
};
var touched = /* @__PURE__ */ new Set();
var controller = O(() => {
	changes.controller.value;
	return controllers.values().next().value ?? null;
});
/** Rises when a vehicle comes or goes: they are sorted then only. */
var members = y$1(0);
var vehicleOrder = O(() => {
	members.value;
	return [...vehicles.keys()].sort((a, b) => NATURAL.compare(a, b));
});
var vehicleList = O(() => {
	changes.vehicles.value;
	return vehicleOrder.value.flatMap((id) => vehicles.get(id) ?? []);
});
/** Doors, buffers and chargers in the order of the plant file. */
var machines = O(() => {
	const { doors = [], buffers = [], chargers: places = [] } = layout.value ?? {};
	const of = (list, kind) => list.map(({ id }) => ({
		id,
		kind
	}));
	return [
		...of(doors, "door"),
		...of(buffers, "buffer"),
		...of(places, "charger")
	];
});
/** What is wrong now, whatever moment is shown. */
var troubles = O(() => {
	changes.vehicles.value;
	changes.devices.value;
	changes.drives.value;
	aside.value;
	const now = inPast.value ? live : maps;
	const [first = null] = now.controller.values();
	controller.value;
	return wrongs({
		controller: first,
		vehicles: now.vehicles.values(),
		devices: now.devices.values(),
		drives: now.drives.values()
	});
});
var driveList = O(() => {
	changes.drives.value;
	return [...drives.values()].sort(byId);
});
function byId(a, b) {
	return NATURAL.compare(a.id, b.id);
}
var closureList = O(() => {
	changes.closures.value;
	return [...closures.values()].sort((a, b) => b.id - a.id);
});
/** The alarms that the controller keeps now, whatever moment is shown, newest first. */
var alarmList = O(() => {
	changes.alarms.value;
	aside.value;
	return [...(inPast.value ? live : maps).alarms.values()].filter((alarm) => alarm.ended === null).sort((a, b) => b.id - a.id);
});
/** What the page itself sees to be wrong and the controller keeps no alarm for: its own trouble, lockouts, holds that were asked for. */
var alongside = O(() => {
	const told = new Set(alarmList.value.flatMap(({ source, cause }) => [source, cause]));
	return troubles.value.filter(({ source, cause }) => !told.has(source) && !told.has(cause));
});
/** How many alarms there are: the one count of them, in the rooms' bar, as the room's title and over the past. */
var alarmCount = O(() => alarmList.value.length + alongside.value.filter(({ grave }) => grave).length);
var unacknowledged = O(() => alarmList.value.filter(({ acknowledged }) => !acknowledged).length);
var stationList = O(() => {
	changes.stations.value;
	return [...stations.values()].sort(byId);
});
var carrierList = O(() => {
	changes.carriers.value;
	return [...carriers.values()].sort(byId);
});
/** Open and ended jobs, newest first; of the past the open ones. */
var jobList = O(() => {
	changes.jobs.value;
	if (inPast.value) return [...jobs.values()].sort((a, b) => b.order - a.order);
	return [...jobs.values(), ...[...ended.values()].filter((job) => !jobs.has(job.id))].sort((a, b) => b.order - a.order);
});
function vehicleNow(id) {
	changes.vehicles.value;
	return vehicles.get(id);
}
function stationNow(id) {
	changes.stations.value;
	return stations.get(id);
}
function deviceNow(id) {
	changes.devices.value;
	return devices.get(id);
}
/** Choose a door, buffer or charger; a buffer is shown with the station that it belongs to. */
function chooseDevice(id) {
	const station = layout.value?.stations.find((one) => one.buffer === id);
	selected.value = station ? {
		kind: "station",
		id: station.id
	} : {
		kind: "device",
		id
	};
}
function driveNow(id) {
	changes.drives.value;
	return drives.get(id);
}
/** AGVs that charge at a charger: those on their way there are named by the server, too. */
function chargingAt(id) {
	const tag = layout.value?.chargers.find((charger) => charger.id === id)?.barcode;
	return [...vehicles.values()].filter((one) => one.activity === "charging" && one.barcode === tag).map((one) => one.id);
}
/** How a door, buffer or charger looks. */
function lookAt(id) {
	const device = devices.get(id);
	if (!layout.value?.chargers.some((charger) => charger.id === id)) return lookOfDevice(device);
	const taken = chargingAt(id).length > 0;
	return device ? lookOfDevice(device, taken) : taken ? "charging" : "free";
}
/** Who is in a door or will pass it, or charges at a charger. */
function passers(id) {
	return [.../* @__PURE__ */ new Set([...devices.get(id)?.vehicles ?? [], ...chargingAt(id)])];
}
/** Who is at which machine, as one text: it changes far less often than the vehicles do. */
var presence = O(() => {
	changes.devices.value;
	changes.vehicles.value;
	return machines.value.map(({ id }) => `${id} ${passers(id).join()}`).join();
});
/** Choose an end of the order; an end at the other side that no vehicle could join to it is forgotten. */
function orderFrom(id) {
	order.source.value = id;
	if (!joins(layout.value, id, order.destination.value)) order.destination.value = "";
}
function orderTo(id) {
	order.destination.value = id;
	if (!joins(layout.value, order.source.value, id)) order.source.value = "";
}
function isTopic(name) {
	return name in maps;
}
/** Whether the past is shown: then the maps have what was, and the stream goes on in books kept aside. */
var inPast = y$1(false);
/** Whether a moment of the past is shown already. */
var pastShown = y$1(false);
/** The server replays a recorded incident: there is no present. */
var recording = y$1(false);
var live = maps;
/** Rises when the books kept aside change. */
var aside = y$1(0);
/** Show something other than the present. */
function lookBack() {
	if (inPast.value) return;
	live = Object.fromEntries(Object.entries(maps).map(([topic, map]) => [topic, new Map(map)]));
	inPast.value = true;
	pastShown.value = false;
	fill$1({});
	members.value++;
	shown();
}
/** Show the present again. */
function backToNow() {
	if (!inPast.value) return;
	fill$1(Object.fromEntries(Object.entries(live).map(([topic, map]) => [topic, Object.fromEntries(map)])));
	live = maps;
	inPast.value = false;
	members.value++;
	shown();
	refreshEnded();
}
/** Show these objects of the past and no others. */
function showWhole(objects) {
	fill$1({
		...objects,
		vehicles: Object.fromEntries(Object.entries(objects["vehicles"] ?? {}).map(([id, now]) => [id, ofThen(id, now)]))
	});
	members.value++;
	pastShown.value = true;
}
/** Show a change of the past; of a vehicle there is only what is other than before. */
function showChange([, topic, key, value]) {
	if (!isTopic(topic)) return;
	const map = maps[topic];
	put(map, topic, key, topic === "vehicles" && value !== null ? vehicleThen(key, value) : value);
}
function vehicleThen(id, value) {
	const before = vehicles.get(id);
	return before ? changedOf(before, value) : ofThen(id, value);
}
function put(map, topic, key, value) {
	if (topic === "vehicles" && map === vehicles && (value === null || !map.has(key))) members.value++;
	if (value === null) map.delete(key);
	else map.set(key, value);
	touched.add(topic);
}
function fill$1(objects, books = maps) {
	for (const topic of Object.keys(books)) {
		const map = books[topic];
		map.clear();
		for (const [key, value] of Object.entries(objects[topic] ?? {})) map.set(key, value);
		touched.add(topic);
	}
}
/** One round for all that changed: what shows several topics is drawn once. */
function shown() {
	r(() => {
		for (const topic of touched) changes[topic].value++;
		touched.clear();
	});
}
function flush() {
	r(() => {
		heardAt.value = Date.now();
		if (inPast.value) aside.value++;
		else shown();
	});
}
var sink = {
	snapshot(objects, lastEvent) {
		const [now] = Object.values(objects["controller"] ?? {});
		recording.value = now?.recording ?? false;
		fill$1(objects, live);
		if (!inPast.value) members.value++;
		connections.value++;
		flush();
		refreshEnded();
		if (happenings.value.length === 0) earlier(lastEvent);
	},
	change(topic, key, value) {
		if (!isTopic(topic)) return;
		if (inPast.value) {
			const map = live[topic];
			if (value === null) map.delete(key);
			else map.set(key, value);
			return;
		}
		put(maps[topic], topic, key, value);
		if (value === null && topic === "jobs") refreshSoon();
	},
	changed: flush,
	events: remember,
	forget() {
		happenings.value = [];
	},
	problem(text) {
		notice.value = text;
	}
};
function remember(events) {
	const known = new Set(happenings.value.map((event) => event.seq));
	happenings.value = [...happenings.value, ...events.filter((event) => !known.has(event.seq))].sort((a, b) => b.seq - a.seq).slice(0, EVENTS_SHOWN);
}
async function earlier(last) {
	if (last < 1) return;
	try {
		remember((await get(`/events?after=${Math.max(0, last - 60)}&limit=60`)).items);
	} catch {}
}
var refreshing = 0;
/** Jobs leave the live model when they end: the list asks for how they ended. */
function refreshSoon() {
	window.clearTimeout(refreshing);
	refreshing = window.setTimeout(() => void refreshEnded(), 250);
}
async function refreshEnded() {
	try {
		const { items } = await get(`/jobs?limit=${ENDED_SHOWN}`);
		ended.clear();
		for (const job of items) if (ENDED.has(job.state)) ended.set(job.id, job);
		changes.jobs.value++;
	} catch {}
}
var stream = new Stream(sink);
var watcher = null;
async function address(after) {
	const query = new URLSearchParams({ topics: TOPICS });
	if (after !== null) query.set("after", String(after));
	try {
		query.set("ticket", (await post("/live/ticket")).ticket);
	} catch (error) {
		if (error instanceof Refused && error.status === 401) return null;
		throw error;
	}
	return `${location.protocol === "https:" ? "wss" : "ws"}://${location.host}/api/v1/live?${query}`;
}
/** What a quiet plant told last still holds while the server answers. */
async function alive() {
	const there = await alive$1();
	if (there && link.value === "live") heardAt.value = Date.now();
	return there;
}
/** Read the layout, then watch; waits for a log-in if the server wants one, and for the server if it is not there. */
async function start() {
	try {
		layout.value = await get("/layout");
	} catch (error) {
		link.value = "lost";
		if (!(error instanceof Refused && error.status === 401)) window.setTimeout(() => void start(), 2e3);
		return;
	}
	watcher ??= new Watcher(stream, {
		address,
		alive,
		state: (now) => link.value = now
	});
	watcher.open();
}
function begin$5() {
	begin$6(() => void (watcher ? watcher.open() : start()), () => link.value = "lost");
	window.setInterval(() => tick.value++, 1e3);
	start();
}
// src/route.ts
/** Which room of the page is open and what is chosen in it, kept in the address: it can be sent to somebody. */
var ROOMS = [
	"map",
	"vehicles",
	"jobs",
	"alarms",
	"closures",
	"stations",
	"walks",
	"teaching",
	"statistics",
	"playback",
	"layouts",
	"access",
	"audit",
	"webhooks"
];
var KINDS$3 = /* @__PURE__ */ new Set([
	"vehicle",
	"station",
	"device",
	"drive",
	"job"
]);
var room$1 = y$1("map");
/** The moment of the past that the address asks for, and the one that it is to name; ISO 8601. */
var momentAsked = y$1(null);
var momentShown = y$1(null);
function isRoom(name) {
	return ROOMS.includes(name);
}
/** What people write by hand. */
var ALSO = {
	layout: "layouts",
	users: "access",
	keys: "access",
	closure: "closures",
	carriers: "stations",
	history: "playback"
};
function read() {
	const [path = "", query = ""] = location.hash.replace(/^#\/?/, "").split("?");
	const known = isRoom(path) ? path : ALSO[path];
	room$1.value = known ?? "map";
	strayed(path && !known ? t("no_room", path) : "");
	const asked = new URLSearchParams(query);
	momentAsked.value = room$1.value === "playback" ? asked.get("at") : null;
	const [kind, id] = [...asked].find(([name]) => KINDS$3.has(name)) ?? [];
	if (kind && id) selected.value = {
		kind,
		id
	};
}
var said = "";
/** Say once that there is no room of that name, until another is entered; "": there is. */
function strayed(words) {
	if (said && notice.value === said) notice.value = "";
	said = words;
	if (words) notice.value = words;
}
/** Follow the address, and keep it up to date. */
function begin$4() {
	read();
	window.addEventListener("hashchange", read);
	room$1.subscribe((now) => now !== "map" && strayed(""));
	x(() => {
		const pick = selected.value;
		const asked = new URLSearchParams(pick ? { [pick.kind]: pick.id } : {});
		const at = momentShown.value ?? momentAsked.peek();
		if (room$1.value === "playback" && at) asked.set("at", at);
		const query = String(asked).replaceAll("%3A", ":");
		const next = `#/${room$1.value}${query && `?${query}`}`;
		if (location.hash !== next) history.replaceState(null, "", next);
	});
}
// src/known.ts
/** Whether the controller has told the page anything, and whether what it told still holds: an empty list may mean that nobody knows. */
/** The controller has told the page something since it was opened; of the past: there is a moment that is shown. */
var answered = O(() => inPast.value ? pastShown.value : heardAt.value > 0);
/** What is shown is what was, since the controller does not answer. */
var away$1 = O(() => link.value !== "live" && heardAt.value > 0);
/** When it was heard last, as time of day at this place. */
var lastHeard = () => clock(new Date(heardAt.value).toISOString());
/** What stands in an empty list: the words for that there is nothing, or that nobody knows. */
function none(words) {
	if (inPast.value) return pastShown.value ? words : t("not_known_then");
	if (heardAt.value === 0) return t("not_known_yet");
	return link.value === "live" ? words : t("not_known_since", lastHeard());
}
/** A count, or a dash where nobody knows. */
var counted = (count) => answered.value ? count : "–";
// src/against.ts
/** What an emergency and a lockout let through: it reads or stops (app/fleet/harmless.py). */
var HARMLESS = /* @__PURE__ */ new Set([
	"status",
	"stop",
	"stop_by_host",
	"agv_mark_stop",
	"agv_lift stop",
	"agv_charge off"
]);
var MANT_ONLY = /* @__PURE__ */ new Set([
	"servo_on",
	"servo_off",
	"search_home",
	"go_home",
	"system_reset",
	"alarm_clear",
	"auto"
]);
/** Something that it was told is not over, though it may stand. */
var DOING = /* @__PURE__ */ new Set([
	"moving",
	"acquiring",
	"depositing"
]);
var lockedOut = (of) => of.lockout ? [
	"against_lockout",
	of.lockout.owner,
	of.lockout.reason
] : null;
var emergency = ({ controller }) => controller?.emergencies.length ? ["against_emergency"] : null;
/** People are at work where it stands. What it covers counts, not what it says: it may not be believed there yet. */
function atWork(vehicle, { closures }) {
	const on = /* @__PURE__ */ new Set([...vehicle.covered, ...vehicle.granted]);
	const found = [...closures].find((one) => one.purpose === "work" && one.state === "closed" && one.kind !== "station" && one.barcodes.some((barcode) => on.has(barcode)));
	return found ? [
		"against_work",
		found.place,
		found.owner
	] : null;
}
var cut$1 = (vehicle) => vehicle.link.up ? null : ["against_link"];
/** Nor has it said anything yet. */
var notLinked = (vehicle) => cut$1(vehicle) ?? (vehicle.mode === null ? ["against_link"] : null);
/** The stretches of track that no edge joins, each named by a barcode of it; of the layout that was asked about last. */
var parted = {
	of: null,
	names: /* @__PURE__ */ new Map()
};
function stretchOf(barcode, layout) {
	if (parted.of !== layout) {
		const above = /* @__PURE__ */ new Map();
		const top = (name) => {
			let at = name;
			for (let next = above.get(at); next !== void 0 && next !== at; next = above.get(at)) {
				above.set(at, above.get(next) ?? next);
				at = next;
			}
			return at;
		};
		for (const { start, end } of layout.edges) {
			const [a, b] = [top(start), top(end)];
			if (!above.has(b)) above.set(b, b);
			above.set(a, b);
		}
		parted = {
			of: layout,
			names: new Map([...above.keys()].map((name) => [name, top(name)]))
		};
	}
	return parted.names.get(barcode) ?? barcode;
}
/**
* Who is missing since the start and may be on this vehicle's stretch of track: whose last place lies on it, or who may be
* wherever its kind drives. One that has said something by now is left to the controller: it may be believed elsewhere.
*/
function missing(vehicle, { controller, layout, vehicles }) {
	const names = controller?.waiting_for ?? [];
	if (names.length === 0 || !layout || vehicle.barcode === null) return [];
	const here = stretchOf(vehicle.barcode, layout);
	const kinds = new Map(layout.vehicles.map(({ id, kind }) => [id, kind]));
	const known = new Map([...vehicles].map((one) => [one.id, one]));
	return names.filter((name) => {
		const other = known.get(name);
		if (!other || other.mode !== null) return false;
		return other.barcode === null ? kinds.get(name) === kinds.get(vehicle.id) : stretchOf(other.barcode, layout) === here;
	});
}
/** Why a person's command cannot reach a vehicle, whatever its mode. */
function outOfReach(vehicle, command, around) {
	const passes = HARMLESS.has(command);
	return (passes ? null : lockedOut(vehicle) ?? atWork(vehicle, around) ?? emergency(around)) ?? notLinked(vehicle) ?? (vehicle.activity === "recovering" && !passes ? ["against_recovery"] : null);
}
/** A hoist's command without data, or `display`. */
function againstCommand(vehicle, command, around) {
	const reach = outOfReach(vehicle, command === "display" ? "stop_by_host" : command, around);
	if (reach) return reach;
	if (MANT_ONLY.has(command) && vehicle.mode !== "mant") return ["against_not_mant", (vehicle.mode ?? "–").toUpperCase()];
	if ((command === "stop_by_host" || command === "display") && vehicle.mode !== "auto" && vehicle.mode !== "semi") return ["against_mant"];
	return command === "display" ? lockedOut(vehicle) : null;
}
/** Why a vehicle cannot be moved, parked or made to handle for a person. */
function againstMove(vehicle, around) {
	if (vehicle.activity === "off_rail") return ["against_off_rail"];
	const barred = lockedOut(vehicle) ?? (vehicle.hold ? ["against_hold"] : null);
	if (barred) return barred;
	if (vehicle.service !== "in_service") return ["against_service"];
	const reach = atWork(vehicle, around) ?? cut$1(vehicle);
	if (reach) return reach;
	if (vehicle.job) return ["against_job", vehicle.job];
	if (vehicle.mode !== "auto") return ["against_not_auto"];
	if (vehicle.oper === "alarm") return ["against_alarm"];
	if (vehicle.activity === "settling" || vehicle.activity === "recovering") return ["against_settling"];
	const absent = missing(vehicle, around);
	return absent.length ? ["against_roll_call", absent.join(", ")] : null;
}
/** Why a vehicle cannot pick up or put down at a station where it stands. */
function againstHandling(vehicle, station, pickup, around) {
	const found = againstMove(vehicle, around);
	if (found) return found;
	const place = around.layout?.stations.find(({ id }) => id === station);
	if (place && place.barcode !== vehicle.barcode) return [
		"against_elsewhere",
		place.barcode,
		vehicle.barcode ?? "?"
	];
	return vehicle.loaded === pickup ? [pickup ? "against_loaded" : "against_empty"] : null;
}
/** Why an AGV cannot do what only AGVs are asked (PROTOCOLS 5.3). */
function againstAgv(vehicle, command, around) {
	const reach = outOfReach(vehicle, command, around);
	if (reach) return reach;
	const error = vehicle.oper === "alarm" ? ["against_alarm"] : null;
	const runs = vehicle.oper === "run" || DOING.has(vehicle.activity);
	const busy = error ?? (vehicle.job ? ["against_job", vehicle.job] : runs ? ["against_runs"] : null);
	const auto = vehicle.mode === "auto" ? null : ["against_agv_manual"];
	switch (command) {
		case "alarm_clear": return error ? null : ["against_no_error"];
		case "agv_mark_stop": return vehicle.oper === "run" ? null : ["against_stands"];
		case "agv_move_manual": return vehicle.mode === "mant" ? error : ["against_agv_auto"];
		case "agv_move_auto": return auto ?? busy;
		case "agv_move_alias": return auto ?? busy ?? againstMove(vehicle, around);
		case "agv_charge on": return auto ?? busy ?? (around.layout?.chargers.some(({ barcode }) => barcode === vehicle.barcode) ? null : ["against_no_charger"]);
		case "agv_set_current":
		case "agv_lift up":
		case "agv_lift down": return busy;
		default: return null;
	}
}
/** Why an alarm is not recovered from now. */
function againstRecovery(vehicle, around) {
	return lockedOut(vehicle) ?? atWork(vehicle, around) ?? emergency(around) ?? notLinked(vehicle);
}
/** Why a person's verdict about a held or absent vehicle would be refused. */
function againstVerdict(vehicle, verdict) {
	if (verdict !== "go_on") return vehicle.link.up ? ["against_linked"] : null;
	if (vehicle.oper === "alarm") return ["against_alarm"];
	return vehicle.hold || vehicle.activity === "off_rail" ? null : ["against_nothing_held"];
}
/** Why a door or buffer would not be asked for this. */
function againstDevice(device, command) {
	if (!device) return ["against_unknown"];
	const lockout = lockedOut(device);
	if (lockout) return lockout;
	if (command !== "open" && !device.fresh) return ["against_silent"];
	if (command === "lock" || command === "unlock") return device.lock && !device.lock.person ? ["against_locked_for", device.lock.owner] : null;
	const wanted = command === "open" ? "open" : "closed";
	if (device.pin && device.pin.position !== wanted) return ["against_pin", device.pin.owner];
	return command === "close" && device.vehicles.length > 0 ? ["against_engaged", device.vehicles.join(", ")] : null;
}
/** Why a door cannot be kept open or closed now. */
function againstPin(device, position) {
	return lockedOut(device) ?? (position === "closed" && device.vehicles.length > 0 ? ["against_engaged", device.vehicles.join(", ")] : null);
}
function againstDrive(drive, asked, around) {
	const harmless = asked === "harmless";
	const lockout = harmless ? null : lockedOut(drive);
	if (lockout) return lockout;
	if (drive.online === null && drive.reason) return ["against_line", drive.line];
	if (drive.online === false && !harmless) return ["against_offline"];
	if (harmless || asked === "read") return null;
	if (drive.operation !== null) return ["against_operation", drive.operation];
	if (asked === "write") return drive.moving ? ["against_drive_runs"] : null;
	if (asked === "change") return null;
	return emergency(around) ?? (drive.mode === "error" ? ["against_drive_error"] : null) ?? (asked === "jog" && drive.mode !== null && drive.mode !== "jog" ? ["against_not_jog"] : null);
}
// src/groups.ts
/** Alarms that have one cause, together: thirty hoists that lost one switch are one thing to know of. Pure. */
var OWN = /\S*\d\S*/g;
/** A cause without the names and numbers in it, each of which is one machine's own. */
function plainOf(alarm) {
	return alarm.cause.replaceAll(alarm.source, "–").replace(OWN, "–");
}
/** What is put together: of the same kind and code; a hold has one code, so that its cause tells them apart. */
var keyOf$1 = (alarm) => `${alarm.kind} ${alarm.code} ${alarm.kind === "hold" ? plainOf(alarm) : ""}`;
/** Groups in the order of their newest alarm, as the list has them. */
function groupsOf(list) {
	const groups = /* @__PURE__ */ new Map();
	for (const alarm of list) {
		const key = keyOf$1(alarm);
		const group = groups.get(key);
		if (!group) groups.set(key, {
			key,
			alarms: [alarm],
			cause: alarm.cause,
			remedy: alarm.remedy
		});
		else {
			group.alarms.push(alarm);
			if (group.cause !== alarm.cause) group.cause = plainOf(alarm);
			if (group.remedy !== alarm.remedy) group.remedy = "";
		}
	}
	return [...groups.values()];
}
/** Whether a vehicle's hold may be released with others' by saying that its report is right: it reports, and is held for no alarm. */
function releasable(vehicle) {
	return Boolean(vehicle?.link.up && againstVerdict(vehicle, "go_on") === null);
}
// node_modules/preact/jsx-runtime/dist/jsxRuntime.mjs
var f = Symbol.for("pv");
var o = 0;
Array.isArray;
function a(t, e, n, u, a, i) {
	e || (e = {});
	var c, l, p = e;
	if ("ref" in p && "function" != typeof t) for (l in p = {}, e) "ref" == l ? c = e[l] : p[l] = e[l];
	var s = {
		type: t,
		props: p,
		key: n,
		ref: c,
		__k: null,
		__: null,
		__b: 0,
		__e: null,
		__c: null,
		constructor: f,
		__v: --o,
		__i: -1,
		__u: 0
	};
	return (a || i) && (s.__source = a, s.__self = i), n$1.vnode && n$1.vnode(s), s;
}
// src/parts/Name.tsx
/** The name of something, which chooses it: of whatever kind there is one of that name. */
function Name({ id }) {
	if (!id) return null;
	const kind = vehicles.has(id) ? "vehicle" : stations.has(id) ? "station" : devices.has(id) ? "device" : drives.has(id) ? "drive" : jobs.has(id) ? "job" : null;
	if (!kind) return /* @__PURE__ */ a($, { children: id });
	return /* @__PURE__ */ a("button", {
		type: "button",
		class: "text",
		onClick: () => selected.value = {
			kind,
			id
		},
		children: id
	});
}
// src/around.ts
/** What a request depends on besides what it is about. */
function around() {
	changes.closures.value;
	return {
		controller: controller.value,
		closures: closures.values(),
		layout: layout.value,
		vehicles: vehicles.values()
	};
}
/** What a button is told: why the controller would refuse it; nothing where nothing speaks against it. */
function stopped(against) {
	return against ? { against: inWords$1(against) } : {};
}
function inWords$1(against) {
	const [word, ...values] = against;
	return t(word, ...values);
}
// src/parts/Problem.tsx
/** What the server said, and what would help. */
function Problem({ error }) {
	if (!error) return null;
	const message = error instanceof Error ? error.message : String(error);
	const remedy = error instanceof Refused ? error.remedy : "";
	return /* @__PURE__ */ a("div", {
		class: "problem",
		role: "alert",
		children: [/* @__PURE__ */ a("b", { children: tell(message) }), remedy && /* @__PURE__ */ a("span", { children: tell(remedy) })]
	});
}
// src/parts/asking.tsx
/** Asking the server for something, and telling what came of it. */
function useAsking() {
	const error = useSignal(null);
	const done = useSignal("");
	const busy = useSignal(false);
	const ask = async (what, words = t("taken")) => {
		error.value = null;
		done.value = "";
		busy.value = true;
		try {
			await what();
			done.value = words;
			return true;
		} catch (failure) {
			error.value = failure;
			return false;
		} finally {
			busy.value = false;
		}
	};
	return {
		error,
		done,
		busy,
		ask
	};
}
/** What came of it: a refusal with what helps, or that it is done. */
function Told({ asking }) {
	return /* @__PURE__ */ a($, { children: [/* @__PURE__ */ a(Problem, { error: asking.error.value }), asking.done.value && /* @__PURE__ */ a("span", {
		class: "done",
		role: "status",
		children: asking.done.value
	})] });
}
/** What a path gives, read again whenever one of these changes, or the server is back; the last answer stays until the next. */
function useRead(path, ...again) {
	const value = useSignal(null);
	const error = useSignal(null);
	A$1(() => {
		let here = true;
		if (path !== null) get(path).then((found) => here && (value.value = found, error.value = null), (failure) => here && (error.value = failure));
		return () => {
			here = false;
		};
	}, [
		path,
		language.value,
		round$2.value,
		connections.value,
		...again
	]);
	return {
		value: value.value,
		error: error.value
	};
}
/** A labelled text or number to be written. */
function Field(props) {
	const { label, value, wide, hint, list, ...rest } = props;
	return /* @__PURE__ */ a("label", {
		class: wide ? "wide" : "",
		children: [/* @__PURE__ */ a("span", { children: label }), /* @__PURE__ */ a("input", {
			...rest,
			...list ? { list } : {},
			placeholder: hint ?? "",
			autocomplete: "off",
			value: value.value,
			onInput: (event) => value.value = event.currentTarget.value
		})]
	});
}
/** A labelled choice. */
function Choice$1(props) {
	return /* @__PURE__ */ a("label", {
		class: props.wide ? "wide" : "",
		children: [/* @__PURE__ */ a("span", { children: props.label }), /* @__PURE__ */ a("select", {
			value: props.value.value,
			onChange: (event) => props.value.value = event.currentTarget.value,
			children: props.of.map(([value, words]) => /* @__PURE__ */ a("option", {
				value,
				children: words
			}, value))
		})]
	});
}
// src/parts/Button.tsx
function Button({ needs, class: looks = "", against, disabled, onClick, title, type = "button", ...rest }) {
	const role = refusal(needs);
	const why = role || against;
	if (!why && !disabled) {
		const press = (event) => {
			barred$1.value = null;
			onClick?.(event);
		};
		return /* @__PURE__ */ a("button", {
			...rest,
			title,
			onClick: press,
			type,
			class: looks,
			"data-needs": needs
		});
	}
	const tell = (event) => {
		event.preventDefault();
		if (why) barred$1.value = {
			why,
			by: role ? "role" : "state"
		};
	};
	return /* @__PURE__ */ a("button", {
		...Object.fromEntries(Object.entries(rest).filter(([name]) => !/^on[A-Z]/.test(name))),
		type,
		class: `${looks} ${role ? "barred" : "stopped"}`,
		"data-needs": needs,
		title: why || title,
		"aria-disabled": true,
		onClick: tell
	});
}
// src/parts/Sure.tsx
/** A button that wants to be pressed twice. */
var PATIENCE = 3500;
function Sure(props) {
	const armed = useSignal(false);
	A$1(() => {
		if (!armed.value) return void 0;
		const timer = window.setTimeout(() => armed.value = false, PATIENCE);
		return () => window.clearTimeout(timer);
	}, [armed.value]);
	const ready = armed.value && !props.against;
	const press = () => {
		if (armed.value) props.does();
		armed.value = !armed.value;
	};
	return /* @__PURE__ */ a(Button, {
		needs: props.needs,
		class: `sure ${props.class ?? ""} ${ready ? "armed" : ""}`,
		disabled: props.disabled ?? false,
		title: props.title ?? "",
		against: props.against,
		onClick: press,
		children: ready ? `${t("sure")} ${props.label}` : props.label
	});
}
// src/parts/Reasoned.tsx
/** Decisions that want a reason: one line to write it, and the buttons. */
function Reasoned({ decisions, title, asking, hint }) {
	const reason = useSignal("");
	const own = useAsking();
	const { ask, busy } = asking ?? own;
	const send = async ({ does }) => {
		if (await ask(() => does(reason.value.trim()))) reason.value = "";
	};
	const wanted = decisions.some((one) => !one.bare || one.noted);
	return /* @__PURE__ */ a("div", {
		class: "stack reasoned",
		children: [
			title && /* @__PURE__ */ a("h3", { children: title }),
			wanted && /* @__PURE__ */ a("input", {
				"aria-label": hint ?? t("reason"),
				placeholder: hint ?? t("reason"),
				maxLength: 200,
				value: reason.value,
				onInput: (event) => reason.value = event.currentTarget.value
			}),
			/* @__PURE__ */ a("div", {
				class: "acts-row",
				children: decisions.map((one) => {
					const lacks = !one.bare && !reason.value.trim();
					const why = one.against ? inWords$1(one.against) : lacks ? t("reason_first") : void 0;
					const idle = busy.value || one.idle === true;
					return one.grave ? /* @__PURE__ */ a(Sure, {
						needs: one.needs,
						label: one.label,
						disabled: idle,
						against: why,
						does: () => void send(one)
					}, one.label) : /* @__PURE__ */ a(Button, {
						needs: one.needs,
						disabled: idle,
						against: why,
						onClick: () => void send(one),
						children: one.label
					}, one.label);
				})
			}),
			/* @__PURE__ */ a(Told, { asking: asking ?? own })
		]
	});
}
// src/parts/AgvCommands.tsx
/** What only AGVs are asked for: driven by hand, along their tape, to a destination by its name, or told at which tag they stand. */
var NEEDS = "POST /vehicles/{vehicle}/commands";
var BY_HAND = [
	"forward",
	"backward",
	"turn_left",
	"turn_right"
];
var ALONG = ["forward", "backward"];
var SPEEDS = [
	"slow",
	"normal",
	"fast"
];
var STEERING = [
	"straight",
	"left",
	"right"
];
function AgvCommands({ send, against }) {
	const speed = useSignal("slow");
	const steering = useSignal("straight");
	const [tag, alias] = [useSignal(""), useSignal("")];
	return /* @__PURE__ */ a($, { children: [
		/* @__PURE__ */ a("div", {
			class: "fields",
			children: [/* @__PURE__ */ a(Choice$1, {
				label: t("speed"),
				value: speed,
				of: SPEEDS.map((name) => [name, t(`speed_${name}`)])
			}), /* @__PURE__ */ a(Choice$1, {
				label: t("at_forks"),
				value: steering,
				of: STEERING.map((name) => [name, t(`agv_${name}`)])
			})]
		}),
		/* @__PURE__ */ a("div", {
			class: "acts-row",
			role: "group",
			"aria-label": t("by_hand"),
			children: [BY_HAND.map((direction) => /* @__PURE__ */ a(Sure, {
				needs: NEEDS,
				label: t(`hand_${direction}`),
				does: () => send({
					command: "agv_move_manual",
					direction,
					speed: speed.value
				}),
				...stopped(against("agv_move_manual"))
			}, direction)), ALONG.map((direction) => /* @__PURE__ */ a(Sure, {
				needs: NEEDS,
				label: t(`tape_${direction}`),
				does: () => send({
					command: "agv_move_auto",
					direction,
					steering: steering.value,
					speed: speed.value
				}),
				...stopped(against("agv_move_auto"))
			}, direction))]
		}),
		/* @__PURE__ */ a("div", {
			class: "fields",
			children: [
				/* @__PURE__ */ a(Field, {
					label: t("agv_alias"),
					name: "alias",
					value: alias,
					list: "agv-aliases"
				}),
				/* @__PURE__ */ a("div", {
					class: "acts-row",
					children: /* @__PURE__ */ a(Sure, {
						needs: NEEDS,
						label: t("move"),
						disabled: !alias.value.trim(),
						does: () => send({
							command: "agv_move_alias",
							alias: alias.value.trim()
						}),
						...stopped(against("agv_move_alias"))
					})
				}),
				/* @__PURE__ */ a(Field, {
					label: t("stands_at_tag"),
					name: "tag",
					value: tag,
					list: "barcode-names"
				}),
				/* @__PURE__ */ a("div", {
					class: "acts-row",
					children: /* @__PURE__ */ a(Sure, {
						needs: NEEDS,
						label: t("tell_it"),
						disabled: !tag.value.trim(),
						does: () => send({
							command: "agv_set_current",
							tag: tag.value.trim()
						}),
						...stopped(against("agv_set_current"))
					})
				})
			]
		}),
		/* @__PURE__ */ a("datalist", {
			id: "agv-aliases",
			children: layout.value?.chargers.flatMap((one) => one.alias ? [/* @__PURE__ */ a("option", { value: one.alias }, one.id)] : [])
		})
	] });
}
// src/parts/VehicleCommands.tsx
/** All that can be asked of a vehicle: each command pressed twice, since it moves or stops something. */
var PLAIN = [
	"status",
	"stop_by_host",
	"stop",
	"auto",
	"alarm_clear",
	"servo_on",
	"servo_off",
	"search_home",
	"go_home",
	"system_reset"
];
var AGV_PLAIN = [
	"stop",
	"alarm_clear",
	"agv_mark_stop"
];
/** An AGV has no MANT that a stop would lead to. */
var AGV_WORDS = { stop: "vc_agv_stop" };
var LIFTS = [
	"up",
	"down",
	"stop"
];
function VehicleCommands({ vehicle }) {
	const asking = useAsking();
	const agv = layout.value?.vehicles.find(({ id }) => id === vehicle.id)?.kind === "agv";
	const path = `/vehicles/${encodeURIComponent(vehicle.id)}`;
	const send = (body) => void asking.ask(() => post(`${path}/commands`, body), t("sent"));
	const plain = agv ? AGV_PLAIN : PLAIN;
	const now = around();
	const against = (command) => (agv ? againstAgv : againstCommand)(vehicle, command, now);
	const charge = vehicle.agv?.charging ? "off" : "on";
	return /* @__PURE__ */ a("details", {
		class: "part acts",
		children: [/* @__PURE__ */ a("summary", { children: t("commands") }), /* @__PURE__ */ a("div", {
			class: "stack",
			children: [
				/* @__PURE__ */ a("div", {
					class: "acts-row",
					"data-commands": vehicle.id,
					children: [
						plain.map((command) => /* @__PURE__ */ a(Sure, {
							needs: "POST /vehicles/{vehicle}/commands",
							label: t(agv && AGV_WORDS[command] || `vc_${command}`),
							does: () => send({ command }),
							...stopped(against(command))
						}, command)),
						agv && LIFTS.map((action) => /* @__PURE__ */ a(Sure, {
							needs: "POST /vehicles/{vehicle}/commands",
							label: t(`vc_lift_${action}`),
							does: () => send({
								command: "agv_lift",
								action
							}),
							...stopped(against(`agv_lift ${action}`))
						}, action)),
						agv && /* @__PURE__ */ a(Sure, {
							needs: "POST /vehicles/{vehicle}/commands",
							label: t(`vc_charge_${charge}`),
							does: () => send({
								command: "agv_charge",
								on: charge === "on"
							}),
							...stopped(against(`agv_charge ${charge}`))
						})
					]
				}),
				/* @__PURE__ */ a("div", {
					class: "acts-row",
					children: /* @__PURE__ */ a(Sure, {
						needs: "POST /vehicles/{vehicle}/park",
						label: t("park"),
						does: () => void asking.ask(() => post(`${path}/park`), t("sent")),
						...stopped(againstMove(vehicle, now))
					})
				}),
				/* @__PURE__ */ a(Move, {
					send,
					against: againstMove(vehicle, now)
				}),
				agv && /* @__PURE__ */ a(AgvCommands, {
					send,
					against
				}),
				!agv && /* @__PURE__ */ a(Handle, {
					send,
					against: (station, pickup) => againstHandling(vehicle, station, pickup, now)
				}),
				!agv && /* @__PURE__ */ a(Display, {
					send,
					against: against("display")
				}),
				/* @__PURE__ */ a(Told, { asking }),
				/* @__PURE__ */ a(Service, {
					vehicle,
					path
				}),
				/* @__PURE__ */ a(Past$2, { path })
			]
		})]
	});
}
/** Out of an alarm, step by step as far as each is safe; homing only when somebody has looked. */
function Recover({ vehicle }) {
	const path = `/vehicles/${encodeURIComponent(vehicle)}`;
	const asking = useAsking();
	const looked = useSignal(false);
	const now = vehicleNow(vehicle);
	const against = now ? againstRecovery(now, around()) : null;
	return /* @__PURE__ */ a("div", {
		class: "stack",
		children: [
			/* @__PURE__ */ a("label", {
				class: "tick",
				children: [
					/* @__PURE__ */ a("input", {
						type: "checkbox",
						checked: looked.value,
						onChange: (event) => looked.value = event.currentTarget.checked
					}),
					" ",
					/* @__PURE__ */ a("span", { children: t("homing_safe") })
				]
			}),
			/* @__PURE__ */ a("div", {
				class: "acts-row",
				children: /* @__PURE__ */ a(Sure, {
					needs: "POST /vehicles/{vehicle}/recover",
					label: t("recover"),
					does: () => void asking.ask(() => post(`${path}/recover`, { confirmed: looked.value }), t("sent")),
					...stopped(against)
				})
			}),
			/* @__PURE__ */ a(Told, { asking })
		]
	});
}
function Move({ send, against }) {
	const barcode = useSignal("");
	const action = useSignal("stop");
	return /* @__PURE__ */ a("div", {
		class: "fields",
		children: [
			/* @__PURE__ */ a(Field, {
				label: t("move_to"),
				value: barcode,
				list: "barcode-names"
			}),
			/* @__PURE__ */ a(Choice$1, {
				label: t("stop_action"),
				value: action,
				of: [
					["stop", t("act_stop")],
					["port", t("port")],
					["sbfl", t("sbfl")],
					["sbfr", t("sbfr")]
				]
			}),
			/* @__PURE__ */ a("div", {
				class: "wide acts-row",
				children: /* @__PURE__ */ a(Sure, {
					needs: "POST /vehicles/{vehicle}/commands",
					label: t("move"),
					disabled: !barcode.value.trim(),
					does: () => send({
						command: "move",
						barcode: barcode.value.trim(),
						action: action.value
					}),
					...stopped(against)
				})
			}),
			/* @__PURE__ */ a("datalist", {
				id: "barcode-names",
				children: (layout.value?.points ?? []).slice(0, 2e3).map(({ barcode: name }) => /* @__PURE__ */ a("option", { value: name }, name))
			})
		]
	});
}
function Handle({ send, against }) {
	const station = useSignal("");
	const place = station.value.trim();
	return /* @__PURE__ */ a("div", {
		class: "fields",
		children: [
			/* @__PURE__ */ a(Field, {
				label: t("at_station"),
				value: station,
				list: "station-names"
			}),
			/* @__PURE__ */ a("div", {
				class: "acts-row",
				children: [/* @__PURE__ */ a(Sure, {
					needs: "POST /vehicles/{vehicle}/commands",
					label: t("vc_pickup"),
					disabled: !place,
					does: () => send({
						command: "pickup",
						station: place
					}),
					...stopped(against(place, true))
				}), /* @__PURE__ */ a(Sure, {
					needs: "POST /vehicles/{vehicle}/commands",
					label: t("vc_place"),
					disabled: !place,
					does: () => send({
						command: "place",
						station: place
					}),
					...stopped(against(place, false))
				})]
			}),
			/* @__PURE__ */ a("datalist", {
				id: "station-names",
				children: layout.value?.stations.map(({ id }) => /* @__PURE__ */ a("option", { value: id }, id))
			})
		]
	});
}
function Display({ send, against }) {
	const words = useSignal("");
	return /* @__PURE__ */ a("div", {
		class: "fields",
		children: [/* @__PURE__ */ a(Field, {
			label: t("display_text"),
			value: words
		}), /* @__PURE__ */ a("div", {
			class: "acts-row",
			children: /* @__PURE__ */ a(Sure, {
				needs: "POST /vehicles/{vehicle}/commands",
				label: t("vc_display"),
				disabled: !words.value,
				does: () => send({
					command: "display",
					text: words.value
				}),
				...stopped(against)
			})
		})]
	});
}
/** Lockout while people are at it, and whether it is used at all. */
function Service({ vehicle, path }) {
	const used = vehicle.service === "in_service";
	return /* @__PURE__ */ a(Reasoned, { decisions: [vehicle.lockout ? {
		label: t("lift_lockout"),
		needs: "DELETE /vehicles/{vehicle}/lockout",
		bare: true,
		grave: true,
		does: () => call("DELETE", `${path}/lockout`)
	} : {
		label: t("lock_out"),
		needs: "POST /vehicles/{vehicle}/lockout",
		grave: true,
		does: (reason) => post(`${path}/lockout`, { reason })
	}, used ? {
		label: t("take_out"),
		needs: "PUT /vehicles/{vehicle}/service",
		grave: true,
		does: (reason) => call("PUT", `${path}/service`, {
			in_service: false,
			reason
		})
	} : {
		label: t("put_back"),
		needs: "PUT /vehicles/{vehicle}/service",
		bare: true,
		does: () => call("PUT", `${path}/service`, { in_service: true })
	}] });
}
/** A command by its button's word, if it has one. */
function commandName(kind) {
	const word = `vc_${kind}`;
	return said$1(word) === word.replaceAll("_", " ") ? kind.replaceAll("_", " ") : said$1(word);
}
function Past$2({ path }) {
	const round = Math.floor(changes.vehicles.value / 30);
	const { value } = useRead(`${path}/commands?limit=12`, round);
	return /* @__PURE__ */ a("table", {
		class: "bits",
		children: /* @__PURE__ */ a("tbody", { children: value?.items.map((command) => /* @__PURE__ */ a("tr", {
			title: command.actor,
			children: [
				/* @__PURE__ */ a("th", { children: clock(command.opened) }),
				/* @__PURE__ */ a("td", { children: commandName(command.kind) }),
				/* @__PURE__ */ a("td", { children: [
					said$1(`cs_${command.state}`),
					" ",
					/* @__PURE__ */ a("small", {
						class: "calm",
						children: tell(command.outcome)
					})
				] })
			]
		}, command.cmd_id)) })
	});
}
// src/parts/AlarmGroups.tsx
/** What is wrong now, one row for each cause: acknowledged at once, and the vehicles held for it released together. */
/** Kinds that stop something by themselves. */
var GRAVE = /* @__PURE__ */ new Set([
	"vehicle",
	"device",
	"drive",
	"traffic",
	"plant"
]);
/** Names that a closed row tells. */
var NAMED$3 = 12;
function AlarmGroup({ group }) {
	const [only] = group.alarms;
	return group.alarms.length === 1 && only ? /* @__PURE__ */ a(Line$4, { alarm: only }) : /* @__PURE__ */ a(Together, { group });
}
function Sign({ kind }) {
	const grave = GRAVE.has(kind);
	return /* @__PURE__ */ a("span", {
		class: `sign ${grave ? "" : "wait"}`,
		title: said$1(kind),
		children: grave ? "!" : "‖"
	});
}
function Line$4({ alarm }) {
	return /* @__PURE__ */ a("li", {
		"data-alarm": `${alarm.kind} ${alarm.source}`,
		children: [
			/* @__PURE__ */ a(Sign, { kind: alarm.kind }),
			/* @__PURE__ */ a("span", { children: [
				/* @__PURE__ */ a("b", { children: /* @__PURE__ */ a(Name, { id: alarm.source }) }),
				" ",
				tell(alarm.cause),
				" ",
				/* @__PURE__ */ a("small", {
					class: "calm",
					children: [
						"· ",
						clock(alarm.begun),
						" · ",
						said$1(alarm.kind)
					]
				})
			] }),
			alarm.remedy && /* @__PURE__ */ a("p", {
				class: "remedy",
				children: tell(alarm.remedy)
			}),
			/* @__PURE__ */ a("div", {
				class: "wide",
				children: [alarm.kind === "vehicle" && vehicles.get(alarm.source)?.oper === "alarm" && /* @__PURE__ */ a(Recover, { vehicle: alarm.source }), alarm.acknowledged ? /* @__PURE__ */ a(Known, { alarm }) : /* @__PURE__ */ a(AcknowledgeOne, { alarm })]
			})
		]
	});
}
function Known({ alarm }) {
	return /* @__PURE__ */ a("small", {
		class: "good",
		children: [
			"✓ ",
			t("known_to", alarm.acknowledged_by ?? "", clock(alarm.acknowledged ?? "")),
			" ",
			alarm.note
		]
	});
}
function AcknowledgeOne({ alarm }) {
	const does = (note) => post(`/alarms/${alarm.id}/acknowledge`, { note });
	return /* @__PURE__ */ a(Reasoned, {
		hint: t("note"),
		decisions: [{
			label: t("acknowledge"),
			needs: "POST /alarms/{alarm}/acknowledge",
			bare: true,
			noted: true,
			does
		}]
	});
}
/** Several of one cause: how many, which, since when; opened, each by itself. */
function Together({ group }) {
	const open = useSignal(false);
	const { alarms } = group;
	const [kind, first] = [alarms[0]?.kind ?? "", alarms.at(-1)?.begun ?? ""];
	return /* @__PURE__ */ a("li", {
		"data-group": kind,
		"data-count": alarms.length,
		children: [
			/* @__PURE__ */ a(Sign, { kind }),
			/* @__PURE__ */ a("span", { children: [
				/* @__PURE__ */ a("b", { children: [alarms.length, " ×"] }),
				" ",
				tell(group.cause),
				" ",
				/* @__PURE__ */ a("small", {
					class: "calm",
					children: [
						"· ",
						t("since", clock(first)),
						" · ",
						said$1(kind)
					]
				})
			] }),
			/* @__PURE__ */ a("p", {
				class: "names",
				children: [alarms.slice(0, NAMED$3).map(({ id, source }) => /* @__PURE__ */ a(Name, { id: source }, id)), alarms.length > NAMED$3 && /* @__PURE__ */ a("span", {
					class: "calm",
					children: t("and_more", alarms.length - NAMED$3)
				})]
			}),
			group.remedy && /* @__PURE__ */ a("p", {
				class: "remedy",
				children: tell(group.remedy)
			}),
			/* @__PURE__ */ a("div", {
				class: "wide",
				children: [/* @__PURE__ */ a(Decisions, { alarms }), /* @__PURE__ */ a("details", {
					open: open.value,
					onToggle: (event) => open.value = event.currentTarget.open,
					children: [/* @__PURE__ */ a("summary", { children: t("each_by_itself") }), open.value && /* @__PURE__ */ a("ul", {
						class: "alarms",
						"aria-label": t("each_by_itself"),
						children: alarms.map((alarm) => /* @__PURE__ */ a(Line$4, { alarm }, alarm.id))
					})]
				})]
			})
		]
	});
}
/** One note acknowledges all, one reason releases all that may be: each is asked for by itself, and answered so. */
function Decisions({ alarms }) {
	const outcomes = useSignal([]);
	changes.vehicles.value;
	const unknown = alarms.filter(({ acknowledged }) => !acknowledged);
	const held = [...new Set(alarms.map(({ source }) => source))].filter((id) => releasable(vehicles.get(id))).sort(NATURAL.compare);
	const acknowledge = async (note) => {
		const { items } = await post("/alarms/acknowledge", {
			alarms: unknown.map(({ id }) => id),
			note
		});
		const named = new Map(alarms.map(({ id, source }) => [id, source]));
		outcomes.value = items.map(({ alarm, acknowledged, detail }) => ({
			name: named.get(alarm) ?? `#${alarm}`,
			against: acknowledged ? "" : detail
		}));
	};
	const release = async (reason) => {
		outcomes.value = [];
		for (const name of held) {
			const failure = await post(`/vehicles/${encodeURIComponent(name)}/release`, {
				verdict: "go_on",
				reason
			}).then(() => "", (why) => why instanceof Error ? why.message : String(why));
			outcomes.value = [...outcomes.value, {
				name,
				against: failure
			}];
		}
	};
	const decisions = [...unknown.length > 0 ? [{
		label: t("acknowledge_all", unknown.length),
		needs: "POST /alarms/acknowledge",
		bare: true,
		noted: true,
		does: acknowledge
	}] : [], ...held.length > 0 ? [{
		label: t("release_all", held.length),
		needs: "POST /vehicles/{vehicle}/release",
		grave: true,
		does: release
	}] : []];
	return /* @__PURE__ */ a($, { children: [
		unknown.length === 0 && /* @__PURE__ */ a("small", {
			class: "good",
			children: ["✓ ", t("all_acknowledged")]
		}),
		decisions.length > 0 && /* @__PURE__ */ a(Reasoned, {
			hint: t("note_or_reason"),
			decisions
		}),
		/* @__PURE__ */ a(Outcomes, { list: outcomes.value })
	] });
}
function Outcomes({ list }) {
	const refused = list.filter(({ against }) => against);
	if (list.length === 0) return null;
	return /* @__PURE__ */ a("div", {
		role: "status",
		"data-outcomes": true,
		children: [/* @__PURE__ */ a("small", {
			class: refused.length ? "" : "good",
			children: t("done_of", list.length - refused.length, list.length)
		}), refused.map(({ name, against }) => /* @__PURE__ */ a("p", {
			class: "bad",
			children: [
				name,
				": ",
				tell(against)
			]
		}, name))]
	});
}
// src/parts/Table.tsx
/** A table that can be sorted by any column and gone through by key; long ones show their beginning. */
var SHOWN$4 = 200;
function compare(a, b) {
	if (a === null || b === null) return a === b ? 0 : a === null ? 1 : -1;
	return typeof a === "number" && typeof b === "number" ? a - b : NATURAL.compare(String(a), String(b));
}
function Table({ label, rows: given, columns, keyOf, pick, chosen, none: none$1 }) {
	const rows = given ?? [];
	const order = useSignal(null);
	const shown = useSignal(SHOWN$4);
	const by = order.value ? columns[order.value.column]?.by : void 0;
	const sign = order.value?.down ? -1 : 1;
	const sorted = by ? rows.toSorted((a, b) => sign * compare(by(a), by(b))) : rows;
	const sort = (column) => {
		const now = order.value;
		if (now?.column !== column) order.value = {
			column,
			down: false
		};
		else order.value = now.down ? null : {
			column,
			down: true
		};
	};
	return /* @__PURE__ */ a("div", {
		class: "scroll",
		tabIndex: 0,
		role: "group",
		"aria-label": label,
		children: [
			/* @__PURE__ */ a("table", {
				class: columns.some(({ wraps }) => wraps) ? "list tidy" : "list",
				children: [/* @__PURE__ */ a("thead", { children: /* @__PURE__ */ a("tr", { children: columns.map((column, i) => {
					const sorts = order.value?.column === i ? order.value.down ? "descending" : "ascending" : "none";
					return /* @__PURE__ */ a("th", {
						class: column.number ? "number" : "",
						"aria-sort": column.by ? sorts : void 0,
						children: column.by ? /* @__PURE__ */ a("button", {
							type: "button",
							onClick: () => sort(i),
							children: [
								column.name,
								" ",
								sorts === "ascending" ? "▲" : sorts === "descending" ? "▼" : ""
							]
						}) : /* @__PURE__ */ a("span", { children: column.name })
					}, column.name);
				}) }) }), /* @__PURE__ */ a("tbody", { children: sorted.slice(0, shown.value).map((row) => {
					const key = keyOf(row);
					return /* @__PURE__ */ a("tr", {
						"data-row": key,
						class: pick ? "pick" : "",
						"aria-selected": pick ? chosen === key : void 0,
						onClick: (event) => {
							if (!event.target.closest("button, input, select, a")) pick?.(row);
						},
						children: columns.map((column) => /* @__PURE__ */ a("td", {
							class: column.number ? "number" : column.wraps ? "wraps" : "",
							children: column.of(row)
						}, column.name))
					}, key);
				}) })]
			}),
			rows.length === 0 && /* @__PURE__ */ a("p", {
				class: "nothing",
				children: given ? none(none$1) : none(t("loading"))
			}),
			rows.length > shown.value && /* @__PURE__ */ a("p", {
				class: "more-rows",
				children: [
					t("more_rows", rows.length - shown.value),
					" ",
					/* @__PURE__ */ a("button", {
						type: "button",
						onClick: () => shown.value += SHOWN$4,
						children: t("show_more")
					})
				]
			})
		]
	});
}
// src/parts/AlarmHistory.tsx
/** Alarms of the past, of one machine or of a kind, page after page. */
var KINDS$2 = [
	"vehicle",
	"hold",
	"link",
	"device",
	"drive",
	"traffic",
	"job",
	"plant"
];
var PAGE$2 = 200;
var lasted = (alarm) => alarm.ended ? Date.parse(alarm.ended) - Date.parse(alarm.begun) : Number.POSITIVE_INFINITY;
function AlarmHistory({ source }) {
	const kind = useSignal("");
	const older = useSignal(null);
	const error = useSignal(null);
	const query = String(new URLSearchParams({
		limit: String(PAGE$2),
		...source.value.trim() ? { source: source.value.trim() } : {},
		...kind.value ? { kind: kind.value } : {}
	}));
	const first = useRead(`/alarms?${query}`, changes.alarms.value);
	const more = older.value?.query === query ? older.value : null;
	const next = more ? more.next : first.value?.next ?? null;
	const known = new Set(first.value?.items.map(({ id }) => id));
	const rows = [...first.value?.items ?? [], ...(more?.items ?? []).filter(({ id }) => !known.has(id))];
	const goOn = async () => {
		try {
			const page = await get(`/alarms?${query}&after=${next}`);
			older.value = {
				query,
				items: [...more?.items ?? [], ...page.items],
				next: page.next
			};
			error.value = null;
		} catch (failure) {
			error.value = failure;
		}
	};
	return /* @__PURE__ */ a("div", {
		class: "filtered",
		children: [/* @__PURE__ */ a("div", {
			class: "filters",
			children: [
				/* @__PURE__ */ a("label", { children: [/* @__PURE__ */ a("span", { children: t("name") }), /* @__PURE__ */ a("input", {
					type: "search",
					value: source.value,
					onChange: (event) => source.value = event.currentTarget.value
				})] }),
				/* @__PURE__ */ a("label", { children: [/* @__PURE__ */ a("span", { children: t("kind") }), /* @__PURE__ */ a("select", {
					value: kind.value,
					onChange: (event) => kind.value = event.currentTarget.value,
					children: [/* @__PURE__ */ a("option", {
						value: "",
						children: t("all")
					}), KINDS$2.map((name) => /* @__PURE__ */ a("option", {
						value: name,
						children: said$1(name)
					}, name))]
				})] }),
				/* @__PURE__ */ a("button", {
					type: "button",
					disabled: next === null,
					onClick: () => void goOn(),
					children: t("older_rows")
				}),
				/* @__PURE__ */ a(Problem, { error: error.value ?? first.error })
			]
		}), /* @__PURE__ */ a(Table, {
			label: t("alarms_history"),
			rows: first.value ? rows : void 0,
			keyOf: (row) => String(row.id),
			none: t("no_alarms_yet"),
			columns: [
				{
					name: "#",
					by: (row) => row.id,
					of: (row) => row.id,
					number: true
				},
				{
					name: t("when"),
					by: (row) => row.begun,
					of: (row) => `${row.begun.slice(5, 10)} ${clock(row.begun)}`
				},
				{
					name: t("kind"),
					by: (row) => row.kind,
					of: (row) => said$1(row.kind)
				},
				{
					name: t("name"),
					by: (row) => row.source,
					of: (row) => /* @__PURE__ */ a(Name, { id: row.source })
				},
				{
					name: t("cause"),
					wraps: true,
					by: (row) => row.code,
					of: (row) => tell(row.cause)
				},
				{
					name: t("takes"),
					by: lasted,
					of: (row) => row.ended ? span(lasted(row)) : t("still"),
					number: true
				},
				{
					name: t("result"),
					wraps: true,
					by: (row) => row.outcome,
					of: (row) => tell(row.outcome)
				},
				{
					name: t("acknowledge"),
					wraps: true,
					by: (row) => row.acknowledged_by,
					of: (row) => [row.acknowledged_by, row.note].filter(Boolean).join(": ")
				}
			]
		})]
	});
}
// src/parts/Reliability.tsx
/** How vehicles held out: failures, mean time between them and to repair; each leads to what failed. */
var PERIODS$1 = {
	shift: 28800,
	day: 86400,
	week: 604800
};
function Reliability({ show }) {
	const period = useSignal("week");
	const round = changes.alarms.value;
	const { value, error } = useRead(`/alarms/reliability?${w$2(() => {
		const now = serverNow();
		return new URLSearchParams({
			from: (/* @__PURE__ */ new Date(now - PERIODS$1[period.value] * 1e3)).toISOString(),
			to: new Date(now).toISOString()
		});
	}, [period.value, round])}`);
	return /* @__PURE__ */ a("div", {
		class: "filtered",
		children: [/* @__PURE__ */ a("div", {
			class: "filters",
			children: [/* @__PURE__ */ a("span", {
				class: "tabs",
				children: Object.keys(PERIODS$1).map((name) => /* @__PURE__ */ a("button", {
					type: "button",
					"aria-pressed": period.value === name,
					onClick: () => period.value = name,
					children: t(`period_${name}`)
				}, name))
			}), /* @__PURE__ */ a(Problem, { error })]
		}), /* @__PURE__ */ a(Table, {
			label: t("reliability"),
			rows: value?.items,
			keyOf: (row) => row.vehicle,
			none: t("nothing_found"),
			columns: [
				{
					name: t("vehicle"),
					by: (row) => row.vehicle,
					of: (row) => /* @__PURE__ */ a(Name, { id: row.vehicle })
				},
				{
					name: t("failures"),
					by: (row) => row.failures,
					of: (row) => row.failures,
					number: true
				},
				{
					name: t("down_minutes"),
					by: (row) => row.down_minutes,
					of: (row) => row.down_minutes.toFixed(1),
					number: true
				},
				{
					name: t("mtbf_hours"),
					by: (row) => row.mtbf_hours,
					of: (row) => row.mtbf_hours?.toFixed(2) ?? "–",
					number: true
				},
				{
					name: t("mttr_minutes"),
					by: (row) => row.mttr_minutes,
					of: (row) => row.mttr_minutes?.toFixed(1) ?? "–",
					number: true
				},
				{
					name: t("availability"),
					by: (row) => row.availability,
					of: (row) => `${(row.availability * 100).toFixed(2)} %`,
					number: true
				},
				{
					name: t("failures_of"),
					of: (row) => /* @__PURE__ */ a("button", {
						type: "button",
						class: "text",
						disabled: row.failures === 0,
						onClick: () => show(row.vehicle),
						children: t("alarms_history")
					})
				}
			]
		})]
	});
}
// src/parts/Alarms.tsx
/** Alarms: what is wrong now with cause, remedy and who knows of it; what was; what they add up to. */
var TABS$1 = [
	"now",
	"history",
	"pareto",
	"reliability"
];
function Alarms() {
	const tab = useSignal("now");
	/** Whose alarms the history is to show; "": everybody's. */
	const source = useSignal("");
	return /* @__PURE__ */ a("section", {
		class: "room",
		"aria-label": t("alarms"),
		children: [
			/* @__PURE__ */ a("div", {
				class: "head",
				children: [/* @__PURE__ */ a("h2", {
					title: t("alarm_count_title", unacknowledged.value),
					children: [
						t("alarms"),
						" ",
						counted(alarmCount.value)
					]
				}), /* @__PURE__ */ a("span", {
					class: "tabs",
					children: TABS$1.map((name) => /* @__PURE__ */ a("button", {
						type: "button",
						"aria-pressed": tab.value === name,
						onClick: () => tab.value = name,
						children: name === "reliability" ? t(name) : t(`alarms_${name}`)
					}, name))
				})]
			}),
			tab.value === "now" && /* @__PURE__ */ a(Present, {}),
			tab.value === "history" && /* @__PURE__ */ a(AlarmHistory, { source }),
			tab.value === "pareto" && /* @__PURE__ */ a(Pareto, {}),
			tab.value === "reliability" && /* @__PURE__ */ a(Reliability, { show: (id) => {
				source.value = id;
				tab.value = "history";
			} })
		]
	});
}
function Present() {
	const others = alongside.value;
	const barred = others.filter(({ grave }) => !grave);
	return /* @__PURE__ */ a("ul", {
		class: "scroll alarms",
		tabIndex: 0,
		"aria-label": t("alarms_now"),
		children: [
			alarmCount.value === 0 && /* @__PURE__ */ a("li", {
				class: "nothing",
				children: none(t("no_alarms"))
			}),
			others.filter(({ grave }) => grave).map((wrong) => /* @__PURE__ */ a(Other, { wrong }, wrong.key)),
			groupsOf(alarmList.value).map((group) => /* @__PURE__ */ a(AlarmGroup, { group }, group.key)),
			barred.length > 0 && /* @__PURE__ */ a("li", {
				class: "sub",
				title: t("no_alarms_but_title"),
				children: t("no_alarms_but", barred.length)
			}),
			barred.map((wrong) => /* @__PURE__ */ a(Other, { wrong }, wrong.key))
		]
	});
}
/** What the page itself sees to be wrong and the server keeps no alarm for: lockouts, say. */
function Other({ wrong }) {
	const { kind, source } = wrong;
	return /* @__PURE__ */ a("li", {
		"data-alarm": wrong.key,
		children: [
			/* @__PURE__ */ a("span", {
				class: `sign ${wrong.grave ? "" : "wait"}`,
				children: wrong.grave ? "!" : "‖"
			}),
			/* @__PURE__ */ a("span", { children: [
				kind === "controller" ? /* @__PURE__ */ a("b", { children: t("controller") }) : /* @__PURE__ */ a("button", {
					type: "button",
					class: "text",
					onClick: () => selected.value = {
						kind,
						id: source
					},
					children: /* @__PURE__ */ a("b", { children: source })
				}),
				" ",
				tell(wrong.cause),
				" ",
				wrong.since && /* @__PURE__ */ a("small", {
					class: "calm",
					children: ["· ", clock(wrong.since)]
				})
			] }),
			wrong.remedy && /* @__PURE__ */ a("p", {
				class: "remedy",
				children: tell(wrong.remedy)
			})
		]
	});
}
/** Counted over so much, s. */
var PARETO = {
	shift: 28800,
	day: 86400,
	week: 604800,
	month: 2592e3
};
function Pareto() {
	const by = useSignal("code");
	const period = useSignal("week");
	const round = changes.alarms.value;
	const from = w$2(() => (/* @__PURE__ */ new Date(serverNow() - PARETO[period.value] * 1e3)).toISOString(), [period.value, round]);
	const { value } = useRead(`/alarms/pareto?by=${by.value}&from=${from}`, round);
	let sum = 0;
	return /* @__PURE__ */ a("div", {
		class: "scroll",
		tabIndex: 0,
		role: "group",
		"aria-label": t("alarms_pareto"),
		children: [
			/* @__PURE__ */ a("div", {
				class: "padded acts-row",
				children: [[
					"code",
					"source",
					"both"
				].map((name) => /* @__PURE__ */ a("button", {
					type: "button",
					"aria-pressed": by.value === name,
					onClick: () => by.value = name,
					children: t(`pareto_${name}`)
				}, name)), /* @__PURE__ */ a("select", {
					"aria-label": t("stretch"),
					class: "narrow",
					value: period.value,
					onChange: (event) => period.value = event.currentTarget.value,
					children: Object.keys(PARETO).map((name) => /* @__PURE__ */ a("option", {
						value: name,
						children: t(`period_${name}`)
					}, name))
				})]
			}),
			/* @__PURE__ */ a("table", {
				class: "list",
				children: /* @__PURE__ */ a("tbody", { children: value?.items.map((row) => {
					sum += row.share;
					return /* @__PURE__ */ a("tr", { children: [
						/* @__PURE__ */ a("td", { children: row.kind ? said$1(row.kind) : "" }),
						/* @__PURE__ */ a("td", { children: [row.source, row.code && tell(row.code)].filter(Boolean).join(" · ") }),
						/* @__PURE__ */ a("td", {
							class: "number",
							children: row.times
						}),
						/* @__PURE__ */ a("td", {
							class: "number",
							children: [row.minutes.toFixed(1), " min"]
						}),
						/* @__PURE__ */ a("td", {
							class: "bar",
							children: /* @__PURE__ */ a("i", { style: { width: `${row.share * 100}%` } })
						}),
						/* @__PURE__ */ a("td", {
							class: "number",
							children: [Math.round(sum * 100), " %"]
						})
					] }, `${row.kind}${row.source}${row.code}`);
				}) })
			}),
			!value?.items.length && /* @__PURE__ */ a("p", {
				class: "nothing",
				children: none(t(value ? "no_alarms_yet" : "loading"))
			})
		]
	});
}
// src/csv.ts
/** What a spreadsheet would take for a formula stands behind an apostrophe: names and reasons come from anybody. */
function cell(value) {
	if (value === null || value === void 0) return "";
	const text = typeof value === "string" && /^[=+\-@\t\r]/.test(value) ? `'${value}` : String(value);
	return /[",\r\n]/.test(text) ? `"${text.replaceAll("\"", "\"\"")}"` : text;
}
/** Rows under the names of their columns. The mark at the beginning tells spreadsheets that it is UTF-8. */
function csvOf(columns, rows) {
	const lines = rows.map((row) => columns.map((name) => cell(row[name])).join(","));
	return `\ufeff${[columns.join(","), ...lines].join("\r\n")}\r\n`;
}
/** Rows by the names in the first line, in lower case; blank lines are left out. Raises Error: a quotation mark too few. */
function rowsOf(text) {
	const lines = table(text.replace(/^\ufeff/, "")).filter((line) => line.some((one) => one.trim() !== ""));
	const names = (lines.shift() ?? []).map((name) => name.trim().toLowerCase());
	return lines.map((line) => Object.fromEntries(names.map((name, i) => [name, (line[i] ?? "").trim().replace(/^'(?=[=+\-@])/, "")])));
}
function table(text) {
	const first = text.slice(0, text.search(/\r|\n|$/));
	const part = first.includes(";") && !first.includes(",") ? ";" : ",";
	const lines = [[]];
	let [value, quoted] = ["", false];
	const end = () => {
		lines.at(-1)?.push(value);
		value = "";
	};
	for (let i = 0; i < text.length; i++) {
		const sign = text[i];
		if (quoted && sign === "\"" && text[i + 1] === "\"") value += text[++i];
		else if (sign === "\"") quoted = !quoted;
		else if (!quoted && sign === part) end();
		else if (!quoted && (sign === "\n" || sign === "\r")) {
			if (sign === "\r" && text[i + 1] === "\n") i++;
			end();
			lines.push([]);
		} else value += sign;
	}
	if (quoted) throw new Error("a quotation mark is never closed");
	end();
	return lines;
}
/** Let the browser save a text. */
function save(text, name, kind = "text/csv") {
	const link = document.createElement("a");
	link.href = URL.createObjectURL(new Blob([text], { type: `${kind};charset=utf-8` }));
	link.download = name;
	link.click();
	URL.revokeObjectURL(link.href);
}
// src/details.ts
/** What an audit row keeps of a request, field by field, told in words: `vehicle V5, what stop` names its fields in English. Pure. */
/** A field of a request -> the page's word for it. */
var FIELDS = {
	vehicle: "vehicle",
	station: "at_station",
	stations: "stations",
	drive: "drive",
	device: "device",
	job: "job",
	carrier: "carrier",
	place: "place",
	zone: "close_zone",
	source: "source",
	destination: "destination",
	priority: "priority",
	reason: "reason",
	what: "what",
	act: "what",
	command: "what",
	key: "field_key",
	kind: "kind",
	barcode: "barcode",
	action: "stop_action",
	present: "present",
	reserved: "reserved",
	out_of_service: "out_of_service",
	by_person: "field_by_person",
	any_vehicle: "field_any_vehicle",
	forgotten: "field_forgotten",
	walked: "field_walked",
	inputs: "inputs",
	parameters: "parameters",
	parameter: "parameters",
	note: "note",
	purpose: "purpose",
	stop: "field_stop",
	side: "kind",
	tag: "tag",
	position: "state",
	line: "on_line",
	idempotency_key: "field_idempotency_key",
	fallbacks: "field_fallbacks",
	text: "field_text",
	alarm: "field_alarm",
	pickup: "field_pickup",
	target: "field_target",
	confirmed: "field_confirmed",
	verdict: "field_verdict",
	pulses: "field_pulses",
	expected: "field_expected",
	raw: "field_raw",
	value: "field_value",
	raw_access: "field_raw_access",
	other: "field_other",
	model: "field_model",
	dry_run: "field_dry_run",
	turn: "field_turn",
	operation: "field_operation",
	session: "field_session",
	abandon: "field_abandon",
	proposal: "field_proposal",
	accept: "field_accept",
	to: "field_to",
	rows: "field_rows",
	expires: "field_expires",
	closure: "field_closure",
	walk: "field_walk",
	partial: "field_partial",
	url: "field_url",
	events: "field_events",
	after: "field_after",
	webhook: "field_webhook",
	active: "field_active",
	overlap: "field_overlap"
};
var isField = (name) => Object.hasOwn(FIELDS, name);
var START = /(^|, )([a-z_]+) /g;
/** Fields and their values in order; null: it is no such list. What is not so (False) is left out. */
function fieldsOf(detail) {
	const starts = [...detail.matchAll(START)].filter(([, , name]) => isField(name ?? ""));
	if (starts[0]?.index !== 0) return null;
	return starts.flatMap((start, i) => {
		const value = detail.slice(start.index + start[0].length, starts[i + 1]?.index ?? detail.length);
		return value === "False" ? [] : [[start[2], plain(value)]];
	});
}
/** A value as people read it: of several switches those that are on, of a list its members. */
function plain(value) {
	const switches = /^\w+\((.*)\)$/.exec(value);
	if (switches) return [...(switches[1] ?? "").matchAll(/(\w+)=True/g)].map(([, name]) => name).join(", ") || "–";
	const list = /^\((.*?),?\)$/.exec(value);
	return list ? (list[1] ?? "").replaceAll("'", "") : value;
}
// src/parts/Audit.tsx
/** The audit: who asked for what, looked for by name, deed, object, outcome and time; whether its chain is whole; as a file. */
var PAGE$1 = 100;
/** Most rows of one file. Our choice: a browser holds them all. */
var MOST$4 = 1e5;
var COLUMNS = [
	"seq",
	"at",
	"actor",
	"action",
	"target",
	"detail",
	"accepted"
];
function queryOf$1(given) {
	const query = new URLSearchParams({ order: "newest" });
	for (const [name, value] of Object.entries(given)) if (value.trim()) query.set(name, value.trim());
	return query.toString();
}
/** What a field for date and time has, as the server wants it. */
function whenOf(local) {
	const at = new Date(local);
	return local && !Number.isNaN(at.getTime()) ? at.toISOString() : "";
}
function Audit() {
	const why = refusal("GET /audit");
	return /* @__PURE__ */ a("section", {
		class: "room",
		"aria-label": t("audit"),
		children: [/* @__PURE__ */ a("div", {
			class: "head",
			children: [/* @__PURE__ */ a("h2", { children: t("audit") }), !why && /* @__PURE__ */ a(Chain, {})]
		}), why ? /* @__PURE__ */ a("p", {
			class: "nothing",
			children: why
		}) : /* @__PURE__ */ a(Rows, {})]
	});
}
/** Whether each row follows from the one before it. */
function Chain() {
	const found = useSignal(null);
	const rows = useSignal(0);
	const asking = useAsking();
	const check = () => void asking.ask(async () => {
		found.value = null;
		rows.value = 0;
		let after = 0;
		while (after !== null) {
			const part = await get(`/audit/check?after=${after}`);
			rows.value += part.rows;
			after = part.next;
			if (after === null) found.value = part;
		}
	}, "");
	const now = found.value;
	return /* @__PURE__ */ a($, { children: [
		now && /* @__PURE__ */ a("span", {
			class: now.broken === null ? "good" : "bad",
			role: "status",
			"data-chain": now.broken === null ? "whole" : "broken",
			title: now.hash,
			children: now.broken === null ? t("chain_whole", rows.value, now.last, now.hash.slice(0, 12)) : t("chain_broken", now.broken, tell(now.reason))
		}),
		asking.busy.value && /* @__PURE__ */ a("span", {
			role: "status",
			children: t("chain_looking", rows.value)
		}),
		/* @__PURE__ */ a(Told, { asking }),
		/* @__PURE__ */ a(Button, {
			needs: "GET /audit/check",
			disabled: asking.busy.value,
			onClick: check,
			children: t("check_chain")
		})
	] });
}
function Rows() {
	const [actor, action, target, begin, end] = [
		useSignal(""),
		useSignal(""),
		useSignal(""),
		useSignal(""),
		useSignal("")
	];
	const accepted = useSignal("");
	const query = useSignal(queryOf$1({}));
	/** Where each page begins; the last is the one that is shown. */
	const pages = useSignal([0]);
	const asking = useAsking();
	const again = useSignal(0);
	const after = pages.value.at(-1) ?? 0;
	const { value } = useRead(`/audit?${query.value}&limit=${PAGE$1}${after ? `&after=${after}` : ""}`, again.value, round$2.value);
	const look = (event) => {
		event.preventDefault();
		query.value = queryOf$1({
			actor: actor.value,
			action: action.value,
			target: target.value,
			accepted: accepted.value,
			from: whenOf(begin.value),
			to: whenOf(end.value)
		});
		pages.value = [0];
		again.value++;
	};
	const write = () => void asking.ask(async () => {
		const rows = [];
		let from = 0;
		while (from !== null && rows.length < MOST$4) {
			const page = await get(`/audit?${query.value}&limit=1000${from ? `&after=${from}` : ""}`);
			rows.push(...page.items);
			from = page.next;
		}
		save(csvOf(COLUMNS, rows), "audit.csv");
	}, "");
	return /* @__PURE__ */ a("div", {
		class: "filtered",
		children: [
			/* @__PURE__ */ a("form", {
				class: "filters",
				role: "search",
				"aria-label": t("audit"),
				onSubmit: look,
				children: [
					/* @__PURE__ */ a(Field, {
						label: t("who"),
						name: "actor",
						value: actor
					}),
					/* @__PURE__ */ a(Field, {
						label: t("what"),
						name: "action",
						value: action,
						list: "audit-actions"
					}),
					/* @__PURE__ */ a(Field, {
						label: t("on_what"),
						name: "target",
						value: target
					}),
					/* @__PURE__ */ a(Choice$1, {
						label: t("result"),
						value: accepted,
						of: [
							["", t("all")],
							["true", t("carried_out")],
							["false", t("refused")]
						]
					}),
					/* @__PURE__ */ a(Field, {
						label: t("since_when"),
						name: "from",
						type: "datetime-local",
						value: begin
					}),
					/* @__PURE__ */ a(Field, {
						label: t("until_when"),
						name: "to",
						type: "datetime-local",
						value: end
					}),
					/* @__PURE__ */ a("button", {
						type: "submit",
						class: "primary",
						children: t("find")
					}),
					/* @__PURE__ */ a("button", {
						type: "button",
						disabled: asking.busy.value,
						onClick: write,
						children: t("save_csv")
					}),
					/* @__PURE__ */ a("datalist", {
						id: "audit-actions",
						children: [...new Set(value?.items.map((row) => row.action))].map((name) => /* @__PURE__ */ a("option", { value: name }, name))
					}),
					/* @__PURE__ */ a(Told, { asking })
				]
			}),
			/* @__PURE__ */ a(Table, {
				label: t("audit"),
				rows: value?.items,
				keyOf: (row) => String(row.seq),
				none: t("no_rows"),
				columns: [
					{
						name: "#",
						of: (row) => row.seq,
						number: true
					},
					{
						name: t("when"),
						of: (row) => moment$1(row.at)
					},
					{
						name: t("who"),
						of: (row) => tell(row.actor)
					},
					{
						name: t("what"),
						of: (row) => /* @__PURE__ */ a(Did, { action: row.action })
					},
					{
						name: t("on_what"),
						of: (row) => tell(row.target)
					},
					{
						name: t("result"),
						of: (row) => /* @__PURE__ */ a("span", {
							class: row.accepted ? "good" : "bad",
							children: t(row.accepted ? "carried_out" : "refused")
						})
					},
					{
						name: t("in_words"),
						wraps: true,
						of: (row) => inWords(row.detail)
					}
				]
			}),
			/* @__PURE__ */ a("div", {
				class: "padded acts-row",
				children: [
					/* @__PURE__ */ a("button", {
						type: "button",
						disabled: pages.value.length < 2,
						onClick: () => pages.value = pages.value.slice(0, -1),
						children: ["◀ ", t("newer_rows")]
					}),
					/* @__PURE__ */ a("span", {
						class: "calm",
						children: t("page_number", pages.value.length)
					}),
					/* @__PURE__ */ a("button", {
						type: "button",
						disabled: !value?.next,
						onClick: () => value?.next && (pages.value = [...pages.value, value.next]),
						children: [t("older_rows"), " ▶"]
					})
				]
			})
		]
	});
}
/** What a row says besides, in the reader's language: a sentence by its pattern, a request field by field. */
function inWords(detail) {
	const told = tell(detail);
	if (language.value === "en" || told !== detail) return told;
	const value = (field, text) => field === "what" || field === "act" ? commandName(text) : text === "True" ? t("yes") : said$1(text);
	return fieldsOf(detail)?.map(([field, text]) => `${t(FIELDS[field])}: ${NAMED$2.has(field) ? text : value(field, text)}`).join(" · ") ?? detail;
}
/** What people or the plant file have named is not translated. */
var NAMED$2 = /* @__PURE__ */ new Set([
	"vehicle",
	"station",
	"stations",
	"drive",
	"device",
	"job",
	"carrier",
	"place",
	"zone",
	"source",
	"destination",
	"reason",
	"note",
	"barcode",
	"tag",
	"idempotency_key",
	"fallbacks",
	"text",
	"other",
	"model",
	"url"
]);
/** What was asked for in words, and by the name that it is looked for by. */
function Did({ action }) {
	const word = said$1(`did_${action}`);
	const named = word !== `did ${action}`;
	return /* @__PURE__ */ a($, { children: [named && /* @__PURE__ */ a($, { children: [word, " "] }), /* @__PURE__ */ a("small", {
		class: named ? "calm technical" : "calm",
		children: action
	})] });
}
// src/parts/Panel.tsx
function Panel(props) {
	const opener = T(document.activeElement);
	const close = () => {
		selected.value = null;
		(opener.current?.isConnected && opener.current !== document.body ? opener.current : document.querySelector("nav.rooms [aria-current]"))?.focus();
	};
	return /* @__PURE__ */ a("section", {
		class: "panel",
		"aria-label": props.title,
		children: [/* @__PURE__ */ a("h2", { children: [
			/* @__PURE__ */ a("i", {
				class: "dot",
				style: { background: props.colour }
			}),
			props.title,
			/* @__PURE__ */ a("span", {
				class: "tag",
				children: props.tag
			}),
			/* @__PURE__ */ a("button", {
				type: "button",
				class: "plain",
				"aria-label": t("close"),
				onClick: close,
				children: "✕"
			})
		] }), /* @__PURE__ */ a("div", {
			class: "scroll body",
			children: props.children
		})]
	});
}
function Fact(props) {
	return /* @__PURE__ */ a($, { children: [/* @__PURE__ */ a("dt", { children: props.name }), /* @__PURE__ */ a("dd", { children: props.children })] });
}
// src/parts/Away.tsx
/** Says over the page that the controller does not answer, and of when what stands there is. */
function Away() {
	tick.value;
	if (inPast.value || answered.value && !away$1.value) return null;
	const never = !answered.value;
	if (never && link.value !== "lost") return null;
	const words = never ? t("away_never") : t("away_since", lastHeard(), t("ago", span(Date.now() - heardAt.value)));
	return /* @__PURE__ */ a("div", {
		class: "banner away",
		role: "alert",
		"data-away": never ? "never" : "since",
		children: [/* @__PURE__ */ a("b", { children: t("link_lost") }), /* @__PURE__ */ a("span", { children: words })]
	});
}
/** In place of a thing's panel: that nothing is known of it, or that there is none. */
function Missing({ id }) {
	return /* @__PURE__ */ a(Panel, {
		title: id,
		tag: t("unknown"),
		colour: "var(--dim)",
		children: /* @__PURE__ */ a("p", {
			class: "nothing",
			children: none(t("no_such"))
		})
	});
}
// src/parts/Barred.tsx
/** Says over the page why a button does nothing, for who is here or as things are, until it is put away. */
function Barred() {
	const now = barred$1.value;
	return /* @__PURE__ */ a("div", {
		class: "toast-place",
		role: "status",
		children: now && /* @__PURE__ */ a("div", {
			class: "toast",
			children: [
				/* @__PURE__ */ a("span", { children: now.why }),
				now.by === "role" && /* @__PURE__ */ a("button", {
					type: "button",
					onClick: () => {
						barred$1.value = null;
						asked$2.value = true;
					},
					children: t("log_in_as_other")
				}),
				/* @__PURE__ */ a("button", {
					type: "button",
					class: "plain",
					"aria-label": t("close"),
					onClick: () => barred$1.value = null,
					children: "✕"
				})
			]
		})
	});
}
document.addEventListener("keydown", (event) => {
	if (event.key === "Escape") barred$1.value = null;
});
// src/parts/DeviceList.tsx
/** Doors, buffers and chargers, each in one line. */
function DeviceList() {
	return /* @__PURE__ */ a("ul", {
		class: "scroll machines",
		children: machines.value.map(({ id, kind }) => /* @__PURE__ */ a(Row$3, {
			id,
			kind
		}, id))
	});
}
/** What people have decided about a device: it does not do what its state alone would let one expect. */
function barred({ lockout, out_of_service, pin }) {
	if (lockout) return `${t("locked", lockout.owner)} ${lockout.reason}`;
	if (out_of_service) return `${t("out_of_service")}: ${out_of_service}`;
	return pin ? `${t("pinned", t(pin.position === "open" ? "device_open" : "device_closed"), pin.owner)}: ${pin.reason}` : "";
}
function Row$3({ id, kind }) {
	const device = deviceNow(id);
	presence.value;
	const look = lookAt(id);
	const station = layout.value?.stations.find((one) => one.buffer === id)?.id;
	const barcode = layout.value?.chargers.find((one) => one.id === id)?.barcode;
	const who = kind === "buffer" ? device?.lock?.owner ?? "" : passers(id).join(", ");
	const why = tell(device?.alarm || device?.contradiction || device && barred(device) || device?.reason || "");
	return /* @__PURE__ */ a("li", { children: /* @__PURE__ */ a("button", {
		type: "button",
		class: "row",
		"aria-pressed": selected.value?.id === id || station !== void 0 && selected.value?.id === station,
		"data-device": id,
		onClick: () => chooseDevice(id),
		children: [
			/* @__PURE__ */ a("i", {
				class: "dot",
				style: { background: colourOfDevice(device, look) }
			}),
			/* @__PURE__ */ a("b", { children: id }),
			/* @__PURE__ */ a("span", { children: t(kind) }),
			/* @__PURE__ */ a("span", {
				style: { color: DEVICE_LOOKS[look] },
				children: t(`device_${look}`)
			}),
			/* @__PURE__ */ a("span", { children: station ?? barcode ?? "" }),
			/* @__PURE__ */ a("span", { children: who }),
			/* @__PURE__ */ a("span", {
				class: device?.alarm ? "more bad" : "more",
				title: why,
				children: why
			})
		]
	}) });
}
// src/parts/DriveList.tsx
/** Axis drives, each in one line: what it does, or what is wrong with it. */
function DriveList() {
	return /* @__PURE__ */ a("ul", {
		class: "scroll machines",
		children: driveList.value.map((drive) => /* @__PURE__ */ a(Row$2, { drive }, drive.id))
	});
}
function Row$2({ drive }) {
	const { word, tone } = lookOfDrive(drive);
	const chosen = selected.value?.kind === "drive" && selected.value.id === drive.id;
	const heard = drive.online === true;
	const why = drive.online ? said$1(drive.meaning) : tell(drive.reason);
	const choose = () => {
		selected.value = chosen ? null : {
			kind: "drive",
			id: drive.id
		};
	};
	return /* @__PURE__ */ a("li", { children: /* @__PURE__ */ a("button", {
		type: "button",
		class: "row drives",
		"aria-pressed": chosen,
		"data-drive": drive.id,
		onClick: choose,
		children: [
			/* @__PURE__ */ a("i", { class: `dot ${tone}` }),
			/* @__PURE__ */ a("b", { children: drive.id }),
			/* @__PURE__ */ a("span", {
				title: tell(drive.name),
				children: tell(drive.name)
			}),
			/* @__PURE__ */ a("span", {
				class: tone,
				children: t(`drive_${word}`)
			}),
			/* @__PURE__ */ a("span", {
				class: "number",
				children: heard && drive.distance !== null ? hundredths(drive.distance) : ""
			}),
			/* @__PURE__ */ a("span", {
				class: tone === "bad" ? "more bad" : "more",
				title: why,
				children: why
			})
		]
	}) });
}
// src/parts/Events.tsx
/** What has happened, newest first. */
var BAD = /AlarmSet|Failed|VehicleHeld|VehicleRemoved|Abort/;
var GOOD = /TransferCompleted|AlarmCleared|VehicleReleased/;
var SHOWN$3 = 80;
function Events() {
	const list = happenings.value;
	return /* @__PURE__ */ a("ol", {
		class: "scroll events",
		reversed: true,
		children: [list.length === 0 && /* @__PURE__ */ a("li", {
			class: "nothing",
			children: none(t("no_events"))
		}), list.slice(0, SHOWN$3).map((event) => /* @__PURE__ */ a(Line$3, { event }, event.seq))]
	});
}
function Line$3({ event }) {
	const tone = BAD.test(event.event) ? "bad" : GOOD.test(event.event) ? "good" : "";
	const where = [event.source, event.destination].filter(Boolean).join(" → ");
	return /* @__PURE__ */ a("li", {
		"data-event": event.seq,
		children: [
			/* @__PURE__ */ a("time", { children: clock(event.ts) }),
			/* @__PURE__ */ a("span", {
				class: "seq",
				children: ["#", event.seq]
			}),
			/* @__PURE__ */ a("b", {
				class: tone,
				children: happening(event.event)
			}),
			event.vehicle ? /* @__PURE__ */ a("button", {
				type: "button",
				class: "text",
				onClick: () => selected.value = {
					kind: "vehicle",
					id: event.vehicle
				},
				children: event.vehicle
			}) : /* @__PURE__ */ a("span", {}),
			/* @__PURE__ */ a("span", {
				class: "more",
				children: [.../* @__PURE__ */ new Set([
					event.job,
					event.carrier,
					where,
					event.result && said$1(event.result),
					tell(event.detail)
				])].filter(Boolean).join(" · ")
			})
		]
	});
}
// src/parts/Frames.tsx
/** The last packets on a line, newest first, each explained field by field. */
var FRAMES_EVERY = 2e3;
function Frames({ path }) {
	const list = useSignal(null);
	const box = T(null);
	A$1(() => {
		let here = true;
		const read = async () => {
			if (box.current?.querySelector("details[open]")) return;
			try {
				const { items } = await get(`${path}?lang=${language.value}`);
				if (here) list.value = items.slice(-30).reverse();
			} catch {}
		};
		read();
		const timer = window.setInterval(() => void read(), FRAMES_EVERY);
		return () => {
			here = false;
			window.clearInterval(timer);
		};
	}, [path, language.value]);
	return /* @__PURE__ */ a("section", {
		class: "frames",
		ref: box,
		children: [
			/* @__PURE__ */ a("h3", { children: t("last_frames") }),
			list.value?.length === 0 && /* @__PURE__ */ a("p", {
				class: "nothing",
				children: t("no_frames")
			}),
			list.value?.map((traffic) => /* @__PURE__ */ a(Frame, { traffic }, `${traffic.at}${traffic.direction}${traffic.hex}`))
		]
	});
}
function Frame({ traffic }) {
	const rows = traffic.frames.flatMap((frame) => frame.fields);
	const main = rows.find((row) => [
		"CMD",
		"MSG",
		"MESSAGE",
		"RESULT"
	].includes(row.name.toUpperCase()));
	const kind = traffic.frames.map((frame) => frame.kind.toUpperCase()).join(" + ");
	return /* @__PURE__ */ a("details", { children: [
		/* @__PURE__ */ a("summary", { children: [
			/* @__PURE__ */ a("span", {
				class: traffic.direction,
				children: traffic.direction === "in" ? "←" : "→"
			}),
			/* @__PURE__ */ a("time", { children: clock(traffic.at) }),
			/* @__PURE__ */ a("b", { children: kind }),
			/* @__PURE__ */ a("span", {
				class: "more",
				children: main ? tell(main.meaning) || main.value : ""
			})
		] }),
		/* @__PURE__ */ a("code", {
			class: "hex",
			children: traffic.hex.match(/../g)?.join(" ")
		}),
		/* @__PURE__ */ a("table", {
			class: "bits",
			children: /* @__PURE__ */ a("tbody", { children: rows.map((row, i) => /* @__PURE__ */ a("tr", { children: [
				/* @__PURE__ */ a("th", {
					style: { paddingLeft: `${row.depth * .7}em` },
					children: row.name
				}),
				/* @__PURE__ */ a("td", { children: tell(row.value) }),
				/* @__PURE__ */ a("td", { children: tell(row.meaning) })
			] }, i)) })
		})
	] });
}
/** The same, asked for only once somebody opens it. */
function LineFrames({ path }) {
	const open = useSignal(false);
	return /* @__PURE__ */ a("details", {
		class: "part acts",
		open: open.value,
		onToggle: (event) => open.value = event.currentTarget.open,
		children: [/* @__PURE__ */ a("summary", { children: t("last_frames") }), open.value && /* @__PURE__ */ a(Frames, { path })]
	});
}
// src/parts/LineList.tsx
/** Lines that carry several devices: connected or not, since when and why not, how they do; and the one stop for all drives on one. */
/** Asked so often, s. */
var EVERY$6 = 3;
function LineList() {
	const { value } = useRead("/links", Math.floor(tick.value / EVERY$6));
	return /* @__PURE__ */ a("ul", {
		class: "scroll alarms lines",
		tabIndex: 0,
		"aria-label": t("lines"),
		children: [!value?.items.length && /* @__PURE__ */ a("li", {
			class: "nothing",
			children: none(t(value ? "no_lines" : "loading"))
		}), value?.items.map((line) => /* @__PURE__ */ a(Row$1, { line }, line.id))]
	});
}
/** A count by its word, if it has one. */
function countName(name) {
	const word = said$1(`count_${name}`);
	return word === `count ${name.replaceAll("_", " ")}` ? name.replaceAll("_", " ") : word;
}
function Row$1({ line }) {
	const open = useSignal(false);
	const asking = useAsking();
	const path = `/links/${encodeURIComponent(line.id)}`;
	const figures = Object.entries(line.figures).map(([name, count]) => `${countName(name)} ${count}`);
	return /* @__PURE__ */ a("li", {
		"data-line": line.id,
		children: [
			/* @__PURE__ */ a("span", {
				class: `sign ${line.up ? "good" : ""}`,
				children: line.up ? "●" : "✕"
			}),
			/* @__PURE__ */ a("span", { children: [
				/* @__PURE__ */ a("b", { children: line.id }),
				" · ",
				line.wire.toUpperCase(),
				" · ",
				line.address,
				" ·",
				" ",
				/* @__PURE__ */ a("span", {
					class: line.up ? "good" : "bad",
					children: t(line.up ? "link_up" : "link_down", line.since ? clock(line.since) : "–")
				}),
				!line.up && line.reason && ` · ${tell(line.reason)}`,
				" ·",
				" ",
				line.devices.map((id) => /* @__PURE__ */ a("span", { children: [/* @__PURE__ */ a(Name, { id }), " "] }, id))
			] }),
			/* @__PURE__ */ a("p", {
				class: "remedy",
				children: figures.join(" · ")
			}),
			/* @__PURE__ */ a("div", {
				class: "wide acts-row",
				children: [
					line.wire === "hi" && /* @__PURE__ */ a(Button, {
						needs: "POST /links/{link}/stop",
						class: "halt",
						onClick: () => void asking.ask(() => post(`${path}/stop?wait=5`), t("line_stopped")),
						children: t("stop_line")
					}),
					/* @__PURE__ */ a("button", {
						type: "button",
						"aria-expanded": open.value,
						onClick: () => open.value = !open.value,
						children: t("last_frames")
					}),
					/* @__PURE__ */ a(Told, { asking })
				]
			}),
			open.value && /* @__PURE__ */ a("div", {
				class: "wide",
				children: /* @__PURE__ */ a(Frames, { path: `${path}/frames` })
			})
		]
	});
}
// src/parts/Below.tsx
/** Below the map: what has happened, and the plant's other machines, each a list to look through and to choose from. */
function Below() {
	const tab = useSignal("events");
	changes.devices.value;
	const counts = {
		events: 0,
		devices: machines.value.length,
		drives: driveList.value.length,
		lines: layout.value?.links?.length ?? 0
	};
	const troubles = {
		events: 0,
		devices: machines.value.filter(({ id }) => /[!?]/.test(signOfDevice(devices.get(id), lookAt(id)))).length,
		drives: driveList.value.filter((drive) => lookOfDrive(drive).tone === "bad").length,
		lines: 0
	};
	const tabs = Object.keys(counts).filter((one) => one === "events" || counts[one] > 0);
	const shown = tabs.includes(tab.value) ? tab.value : "events";
	return /* @__PURE__ */ a("section", {
		class: "card below",
		"aria-label": t(shown),
		children: [
			/* @__PURE__ */ a("h2", { children: [tabs.length === 1 && t("events"), tabs.length > 1 && /* @__PURE__ */ a("span", {
				class: "tabs",
				children: tabs.map((one) => /* @__PURE__ */ a("button", {
					type: "button",
					"aria-pressed": shown === one,
					onClick: () => tab.value = one,
					children: [
						t(one),
						" ",
						counts[one] || "",
						troubles[one] > 0 && /* @__PURE__ */ a("b", {
							class: "badge",
							children: ["! ", troubles[one]]
						})
					]
				}, one))
			})] }),
			shown === "events" && /* @__PURE__ */ a(Events, {}),
			shown === "devices" && /* @__PURE__ */ a(DeviceList, {}),
			shown === "drives" && /* @__PURE__ */ a(DriveList, {}),
			shown === "lines" && /* @__PURE__ */ a(LineList, {})
		]
	});
}
// src/closed.ts
/** Which track people have closed or are about to close, for the map. */
/** A stretch of track, from one barcode to another, in no language. */
var placed = (place) => place.replace(/^(\S+) to (\S+)$/, "$1 → $2");
/** Told which barcode was clicked, while somebody chooses track on the map. */
var choosing = y$1(null);
/** Barcodes that a closure that is only looked at would keep empty. */
var previewed = y$1([]);
/** Pairs of barcodes: the way from the first to the second is closed. */
var closedWays = O(() => {
	const list = closureList.value;
	const barcodes = new Set(list.filter(({ kind }) => kind !== "edge" && kind !== "station").flatMap((one) => one.barcodes));
	return [...list.filter(({ kind }) => kind === "edge").map(({ names }) => [names[0], names[1]]), ...waysInto(barcodes)];
});
var previewedWays = O(() => waysInto(new Set(previewed.value)));
function waysInto(barcodes) {
	if (barcodes.size === 0) return [];
	return (layout.value?.edges ?? []).filter(({ end }) => barcodes.has(end)).map(({ start, end }) => [start, end]);
}
// src/parts/ClosedBefore.tsx
/** What was closed before: by whom, why, how long, and who opened it. */
function ClosedBefore() {
	const open = useSignal(false);
	const { value } = useRead(open.value ? "/closures/history?limit=50" : null, changes.closures.value);
	const past = value?.items.filter(({ ended }) => ended !== null) ?? [];
	return /* @__PURE__ */ a("details", {
		class: "padded",
		open: open.value,
		onToggle: (event) => open.value = event.currentTarget.open,
		children: [
			/* @__PURE__ */ a("summary", { children: t("closed_before") }),
			open.value && value && past.length === 0 && /* @__PURE__ */ a("p", {
				class: "nothing",
				children: t("nothing_found")
			}),
			/* @__PURE__ */ a("ul", { children: past.map((closure) => /* @__PURE__ */ a("li", { children: [
				/* @__PURE__ */ a("b", { children: placed(closure.place) }),
				" · ",
				closure.reason,
				" · ",
				closure.owner,
				" · ",
				moment$1(closure.since),
				" – ",
				moment$1(closure.ended ?? ""),
				" ",
				/* @__PURE__ */ a("span", {
					class: "calm",
					children: [
						said$1(closure.state),
						" ",
						closure.ended_by
					]
				})
			] }, closure.id)) })
		]
	});
}
// src/parts/Kept.tsx
/** What routes keep off, whom that cuts off, and how vehicles are led round it: in the header in few words, in full among the closures. */
/** A line that begins with places or a station, told in the words of who reads it. */
function retold(line) {
	const at = line.indexOf(": ");
	return at < 0 ? tell(line) : `${line.slice(0, at)}: ${tell(line.slice(at + 2))}`;
}
/** What the count of reasons is of: the same in the header and above the list. */
var keptTitle = (now) => t("kept_off_title", now.kept_off.length, now.closed_places);
/** In the header, only if anything is the matter. */
function KeptOff() {
	const now = controller.value;
	if (!now || now.kept_off.length + now.cut_off.length === 0) return null;
	const words = [...now.kept_off.length ? [`${t("kept_off")} ${now.kept_off.length}`] : [], ...now.cut_off.length ? [t("stations_cut_off", now.cut_off.length)] : []];
	return /* @__PURE__ */ a("button", {
		type: "button",
		class: `kept ${now.cut_off.length ? "bad" : "wait"}`,
		title: [keptTitle(now), ...[...now.cut_off, ...now.kept_off].map(retold)].join("\n"),
		onClick: () => room$1.value = "closures",
		children: words.join(" · ")
	});
}
/** Every reason, every station cut off, and what was done about it. */
function KeptList() {
	const now = controller.value;
	if (!now) return null;
	const led = [
		...now.led_round ? [t("led_round", now.led_round)] : [],
		...now.led_quicker ? [t("led_quicker", now.led_quicker)] : [],
		...now.slow_track ? [t("slow_track", now.slow_track)] : [],
		...now.weighed ? [t("weighed", now.weighed)] : [],
		...now.restrained_to != null ? [t("restrained_to", now.restrained_to)] : []
	];
	return /* @__PURE__ */ a($, { children: [
		now.cut_off.length > 0 && /* @__PURE__ */ a(Lines, {
			title: t("cut_off_now"),
			explained: t("cut_off_title"),
			lines: now.cut_off,
			sign: "✕",
			tone: ""
		}),
		now.kept_off.length > 0 && /* @__PURE__ */ a(Lines, {
			title: t("kept_off"),
			explained: keptTitle(now),
			lines: now.kept_off,
			sign: "⤳",
			tone: "wait"
		}),
		led.length > 0 && /* @__PURE__ */ a("p", {
			class: "padded calm",
			"data-led": true,
			children: [
				t("since_start"),
				": ",
				led.join(" · ")
			]
		})
	] });
}
function Lines({ title, explained, lines, sign, tone }) {
	return /* @__PURE__ */ a($, { children: [/* @__PURE__ */ a("h2", {
		class: "sub",
		title: explained,
		children: [
			title,
			" ",
			lines.length
		]
	}), /* @__PURE__ */ a("ul", {
		class: "alarms",
		"aria-label": title,
		children: lines.map((words) => /* @__PURE__ */ a("li", { children: [/* @__PURE__ */ a("span", {
			class: `sign ${tone}`,
			children: sign
		}), /* @__PURE__ */ a("span", { children: retold(words) })] }, words))
	})] });
}
/** Why a station cannot be reached now; null: nothing says so. */
function cutOff(id) {
	return controller.value?.cut_off.find((words) => words.startsWith(`${id}: `)) ?? null;
}
function CutOff({ id }) {
	const words = cutOff(id);
	return words && /* @__PURE__ */ a("p", {
		class: "note alarm",
		"data-cut-off": id,
		children: [
			/* @__PURE__ */ a("b", { children: t("not_reachable") }),
			" ",
			tell(words.slice(id.length + 2))
		]
	});
}
// src/parts/Closures.tsx
/** What is closed, and closing more: a look at what it would do comes first. Track can be chosen on the map above. */
function Closures() {
	tick.value;
	return /* @__PURE__ */ a("section", {
		class: "room closing",
		"aria-label": t("closures"),
		children: /* @__PURE__ */ a("div", {
			class: "split",
			children: [/* @__PURE__ */ a("div", {
				tabIndex: 0,
				role: "group",
				"aria-label": t("closures"),
				children: [
					/* @__PURE__ */ a("h2", {
						class: "sub",
						title: t("closures_title"),
						children: [
							t("closures_by_people"),
							" ",
							counted(closureList.value.length)
						]
					}),
					closureList.value.length === 0 && /* @__PURE__ */ a("p", {
						class: "nothing",
						children: none(t("nothing_closed"))
					}),
					/* @__PURE__ */ a("ul", {
						class: "alarms",
						children: closureList.value.map((closure) => /* @__PURE__ */ a(Line$2, { closure }, closure.id))
					}),
					/* @__PURE__ */ a(KeptList, {}),
					/* @__PURE__ */ a(Zones, {}),
					/* @__PURE__ */ a(ClosedBefore, {})
				]
			}), /* @__PURE__ */ a(Close, {})]
		})
	});
}
function Line$2({ closure }) {
	const left = closure.expires ? Date.parse(closure.expires) - serverNow() : null;
	return /* @__PURE__ */ a("li", {
		"data-closure": closure.id,
		children: [
			/* @__PURE__ */ a("span", {
				class: `sign ${closure.state === "draining" ? "wait" : ""}`,
				children: closure.state === "draining" ? "…" : "✕"
			}),
			/* @__PURE__ */ a("span", { children: [
				/* @__PURE__ */ a("b", { children: placed(closure.place) }),
				" · ",
				said$1(closure.state),
				" · ",
				said$1(closure.purpose),
				": ",
				closure.reason
			] }),
			/* @__PURE__ */ a("p", {
				class: "remedy",
				children: [
					closure.owner,
					" · ",
					t("since", clock(closure.since)),
					left !== null && ` · ${t("ends_in", span(left))}`,
					closure.releases.length > 0 && ` · ${t("release_wished", closure.releases.join(", "))}`
				]
			}),
			closure.waiting.map((words) => /* @__PURE__ */ a("p", {
				class: "wait",
				children: tell(words)
			}, words)),
			/* @__PURE__ */ a("div", {
				class: "wide",
				children: /* @__PURE__ */ a(Reasoned, { decisions: [{
					label: t("open_it"),
					needs: "POST /closures/{closure}/open",
					bare: true,
					grave: true,
					does: () => post(`/closures/${closure.id}/open`, {})
				}] })
			})
		]
	});
}
/** Zones of the plant: paused, stopped, resumed. */
function Zones() {
	const { value } = useRead("/zones", controller.value?.pauses, Math.floor(tick.value / 3));
	if (!value?.items.length) return null;
	return /* @__PURE__ */ a($, { children: [/* @__PURE__ */ a("h2", {
		class: "sub",
		children: t("layer_zones")
	}), /* @__PURE__ */ a("ul", {
		class: "alarms zones",
		children: value.items.map((zone) => /* @__PURE__ */ a("li", {
			"data-zone": zone.id,
			children: [
				/* @__PURE__ */ a("span", {
					class: "sign wait",
					children: zone.state === "auto" ? "" : "‖"
				}),
				/* @__PURE__ */ a("span", { children: [
					/* @__PURE__ */ a("b", { children: tell(zone.name) || zone.id }),
					" · ",
					said$1(zone.state),
					" · ",
					zone.vehicles.length,
					" / ",
					zone.capacity,
					" ",
					zone.vehicles.map((id) => /* @__PURE__ */ a("span", { children: [/* @__PURE__ */ a(Name, { id }), " "] }, id))
				] }),
				zone.pause && /* @__PURE__ */ a("p", {
					class: "remedy",
					children: [
						zone.pause.owner,
						": ",
						zone.pause.reason
					]
				}),
				/* @__PURE__ */ a("details", { children: [/* @__PURE__ */ a("summary", { children: t("change") }), /* @__PURE__ */ a(Reasoned, { decisions: [
					{
						label: t("pause"),
						needs: "POST /zones/{zone}/pause",
						does: (reason) => post(`/zones/${encodeURIComponent(zone.id)}/pause`, { reason })
					},
					{
						label: t("stop_zone"),
						needs: "POST /zones/{zone}/stop",
						grave: true,
						does: (reason) => post(`/zones/${encodeURIComponent(zone.id)}/stop`, { reason })
					},
					{
						label: t("resume"),
						needs: "POST /zones/{zone}/resume",
						bare: true,
						does: () => post(`/zones/${encodeURIComponent(zone.id)}/resume`)
					}
				] })] })
			]
		}, zone.id))
	})] });
}
function Close() {
	const kind = useSignal("stretch");
	const from = useSignal("");
	const to = useSignal("");
	const purpose = useSignal("traffic");
	const minutes = useSignal("");
	const reason = useSignal("");
	const preview = useSignal(null);
	const asking = useAsking();
	const two = kind.value === "stretch" || kind.value === "edge";
	A$1(() => {
		choosing.value = (barcode) => {
			if (kind.value === "zone" || kind.value === "station") return;
			if (!from.value || two && to.value || !two) [from.value, to.value] = [barcode, ""];
			else to.value = barcode;
		};
		return () => {
			choosing.value = null;
			previewed.value = [];
		};
	}, [two]);
	A$1(() => {
		preview.value = null;
		previewed.value = [];
	}, [
		kind.value,
		from.value,
		to.value
	]);
	const place = () => {
		const [a, b] = [from.value.trim(), to.value.trim()];
		if (kind.value === "stretch" || kind.value === "edge") return {
			kind: kind.value,
			from: a,
			to: b
		};
		if (kind.value === "zone") return {
			kind: "zone",
			zone: a
		};
		return kind.value === "station" ? {
			kind: "station",
			station: a
		} : {
			kind: "barcode",
			barcodes: a.split(/[\s,]+/)
		};
	};
	const look = async () => {
		preview.value = null;
		await asking.ask(async () => {
			preview.value = await post("/closures/preview", { place: place() });
			previewed.value = preview.value.barcodes;
		}, "");
	};
	const close = async () => {
		const body = {
			place: place(),
			reason: reason.value.trim(),
			purpose: purpose.value,
			...minutes.value ? { minutes: Number(minutes.value) } : {}
		};
		if (!await asking.ask(() => post("/closures", body), t("closes_now"))) return;
		[preview.value, previewed.value, reason.value] = [
			null,
			[],
			""
		];
	};
	const whole = Boolean(from.value.trim() && (!two || to.value.trim()));
	return /* @__PURE__ */ a("form", {
		class: "stack padded",
		"aria-label": t("close_place"),
		onSubmit: (event) => {
			event.preventDefault();
			preview.value ? close() : look();
		},
		children: [
			/* @__PURE__ */ a("h2", {
				class: "sub",
				children: t("close_place")
			}),
			/* @__PURE__ */ a("div", {
				class: "fields",
				children: [
					/* @__PURE__ */ a(Choice$1, {
						label: t("kind"),
						value: kind,
						of: [
							["stretch", t("close_stretch")],
							["edge", t("close_edge")],
							["barcode", t("close_barcode")],
							["zone", t("close_zone")],
							["station", t("at_station")]
						]
					}),
					/* @__PURE__ */ a(Field, {
						label: two ? t("close_from") : t("name"),
						name: "from",
						value: from,
						list: kind.value === "zone" ? "zone-names" : "place-names"
					}),
					two && /* @__PURE__ */ a(Field, {
						label: t("close_to"),
						name: "to",
						value: to
					}),
					/* @__PURE__ */ a(Choice$1, {
						label: t("purpose"),
						value: purpose,
						of: [["traffic", t("traffic")], ["work", t("work")]]
					}),
					purpose.value === "traffic" && /* @__PURE__ */ a(Field, {
						label: t("minutes"),
						name: "minutes",
						type: "number",
						min: 1,
						value: minutes,
						hint: t("until_opened")
					}),
					/* @__PURE__ */ a(Field, {
						label: t("reason"),
						name: "reason",
						value: reason,
						wide: true
					})
				]
			}),
			/* @__PURE__ */ a("datalist", {
				id: "zone-names",
				children: layout.value?.zones.map(({ id }) => /* @__PURE__ */ a("option", { value: id }, id))
			}),
			/* @__PURE__ */ a("datalist", {
				id: "place-names",
				children: kind.value === "station" && layout.value?.stations.map(({ id }) => /* @__PURE__ */ a("option", { value: id }, id))
			}),
			/* @__PURE__ */ a("p", {
				class: "calm",
				children: t(kind.value === "station" || kind.value === "zone" ? "look_first" : "choose_on_map")
			}),
			/* @__PURE__ */ a("div", {
				class: "acts-row",
				children: [/* @__PURE__ */ a("button", {
					type: "button",
					disabled: !whole,
					onClick: () => void look(),
					children: t("preview")
				}), /* @__PURE__ */ a(Button, {
					needs: "POST /closures",
					type: "submit",
					class: "halt",
					disabled: !whole || !reason.value.trim() || !preview.value,
					children: t("close_place")
				})]
			}),
			/* @__PURE__ */ a(Told, { asking }),
			preview.value && /* @__PURE__ */ a(Effects, { preview: preview.value })
		]
	});
}
/** The jobs that a closure would touch, each with why; the server names the first of them. */
function Jobs$1({ touched, jobs }) {
	return /* @__PURE__ */ a($, { children: [
		/* @__PURE__ */ a("b", { children: t("jobs_touched", touched) }),
		/* @__PURE__ */ a("ul", {
			class: "plain",
			"aria-label": t("jobs_touched", touched),
			children: jobs.map(({ job, why }) => /* @__PURE__ */ a("li", { children: [
				/* @__PURE__ */ a(Name, { id: job }),
				": ",
				tell(why)
			] }, job))
		}),
		touched > jobs.length && /* @__PURE__ */ a("small", {
			class: "calm",
			children: t("and_more", touched - jobs.length)
		})
	] });
}
function Effects({ preview }) {
	const { routes } = preview;
	const names = (label, list) => list.length > 0 && /* @__PURE__ */ a("p", { children: [
		/* @__PURE__ */ a("b", { children: label }),
		" ",
		list.slice(0, 30).map((id) => /* @__PURE__ */ a("span", { children: [/* @__PURE__ */ a(Name, { id }), " "] }, id)),
		list.length > 30 && t("more_rows", list.length - 30)
	] });
	return /* @__PURE__ */ a("div", {
		class: "note stack",
		"data-preview": true,
		children: [
			/* @__PURE__ */ a("b", { children: placed(preview.place) }),
			names(t("stations_closed"), preview.stations),
			names(t("cut_off"), preview.cut_off),
			names(t("drive_out"), preview.inside),
			names(t("shut_in"), preview.shut_in),
			preview.jobs_touched > 0 && /* @__PURE__ */ a(Jobs$1, {
				touched: preview.jobs_touched,
				jobs: preview.jobs
			}),
			/* @__PURE__ */ a("p", { children: [
				preview.jobs_touched === 0 && `${t("jobs_touched", 0)} · `,
				t("routes_longer", routes.longer, routes.compared),
				" · ",
				t("routes_lost", routes.lost)
			] }),
			/* @__PURE__ */ a("p", { children: t("routes_mean", routes.mean_seconds.toFixed(1), routes.mean_seconds_after.toFixed(1)) }),
			routes.worst.slice(0, 3).map((one) => /* @__PURE__ */ a("p", {
				class: "calm",
				children: [
					one.from,
					" → ",
					one.to,
					": ",
					one.seconds.toFixed(0),
					" → ",
					one.seconds_after.toFixed(0),
					" s"
				]
			}, one.from + one.to))
		]
	});
}
// src/parts/DeviceDecisions.tsx
/** What people decide about a door, buffer or charger: kept open or closed, locked out, out of service. */
function DeviceDecisions({ device }) {
	const path = `/devices/${encodeURIComponent(device.id)}`;
	const decisions = [
		...device.kind !== "door" ? [] : device.pin ? [{
			label: t("unpin"),
			needs: "DELETE /devices/{device}/pin",
			bare: true,
			does: () => call("DELETE", `${path}/pin`)
		}] : ["open", "closed"].map((position) => ({
			label: t(`pin_${position}`),
			needs: "PUT /devices/{device}/pin",
			against: againstPin(device, position),
			does: (reason) => call("PUT", `${path}/pin`, {
				position,
				reason
			})
		})),
		device.lockout ? {
			label: t("lift_lockout"),
			needs: "DELETE /devices/{device}/lockout",
			bare: true,
			grave: true,
			does: () => call("DELETE", `${path}/lockout`)
		} : {
			label: t("lock_out"),
			needs: "POST /devices/{device}/lockout",
			grave: true,
			does: (reason) => post(`${path}/lockout`, { reason })
		},
		device.out_of_service ? {
			label: t("put_back"),
			needs: "PUT /devices/{device}/service",
			bare: true,
			does: () => call("PUT", `${path}/service`, { in_service: true })
		} : {
			label: t("take_out"),
			needs: "PUT /devices/{device}/service",
			grave: true,
			does: (reason) => call("PUT", `${path}/service`, {
				in_service: false,
				reason
			})
		}
	];
	return /* @__PURE__ */ a("details", {
		class: "part acts",
		children: [/* @__PURE__ */ a("summary", { children: t("decide") }), /* @__PURE__ */ a(Reasoned, { decisions })]
	});
}
// src/parts/DeviceMore.tsx
/** What was asked of a door or buffer lately and what became of it, and the packets on its line. */
function DeviceMore({ device }) {
	const path = `/devices/${encodeURIComponent(device.id)}`;
	return /* @__PURE__ */ a($, { children: [/* @__PURE__ */ a(Past$1, { path }), device.link && /* @__PURE__ */ a(LineFrames, { path: `${path}/frames` })] });
}
function Past$1({ path }) {
	const open = useSignal(false);
	const { value } = useRead(open.value ? `${path}/commands?limit=12` : null, changes.devices.value);
	return /* @__PURE__ */ a("details", {
		class: "part acts",
		open: open.value,
		onToggle: (event) => open.value = event.currentTarget.open,
		children: [
			/* @__PURE__ */ a("summary", { children: t("last_commands") }),
			value?.items.length === 0 && /* @__PURE__ */ a("p", {
				class: "nothing",
				children: t("no_commands")
			}),
			/* @__PURE__ */ a("table", {
				class: "bits",
				children: /* @__PURE__ */ a("tbody", { children: value?.items.map((command) => /* @__PURE__ */ a("tr", { children: [
					/* @__PURE__ */ a("th", { children: clock(command.opened) }),
					/* @__PURE__ */ a("td", { children: said$1(`cs_${command.state}`) }),
					/* @__PURE__ */ a("td", { children: [
						commandName(command.kind),
						" · ",
						command.actor,
						" ",
						tell(command.outcome)
					] })
				] }, command.cmd_id)) })
			})
		]
	});
}
// src/parts/DevicePanel.tsx
/** One door, buffer or charger: its state and since when, who has it, what is wrong, and the two commands it takes. */
var COMMANDS = {
	door: ["open", "close"],
	buffer: ["lock", "unlock"],
	charger: []
};
function DevicePanel({ id }) {
	const kind = machines.value.find((machine) => machine.id === id)?.kind;
	const now = deviceNow(id);
	presence.value;
	if (!kind) return null;
	return /* @__PURE__ */ a(Panel, {
		title: id,
		tag: t(kind),
		colour: colourOfDevice(now, lookAt(id)),
		children: /* @__PURE__ */ a(DeviceBody, { id })
	});
}
/** What there is to say of a device, in its own panel or in that of its station. */
function DeviceBody({ id }) {
	const kind = machines.value.find((machine) => machine.id === id)?.kind;
	const now = deviceNow(id);
	tick.value;
	presence.value;
	if (!kind) return null;
	const barcode = layout.value?.chargers.find((charger) => charger.id === id)?.barcode;
	return /* @__PURE__ */ a($, { children: [
		now && /* @__PURE__ */ a(Notes$2, { device: now }),
		/* @__PURE__ */ a("dl", { children: [
			/* @__PURE__ */ a(Fact, {
				name: t("state"),
				children: /* @__PURE__ */ a(State, {
					look: lookAt(id),
					device: now
				})
			}),
			kind !== "buffer" && /* @__PURE__ */ a(Fact, {
				name: t(kind === "charger" ? "charges" : "passing"),
				children: /* @__PURE__ */ a(Vehicles$1, { ids: passers(id) })
			}),
			now?.waiting && now.waiting.length > 0 && /* @__PURE__ */ a(Fact, {
				name: t("wait_for_it"),
				children: /* @__PURE__ */ a(Vehicles$1, { ids: now.waiting })
			}),
			kind === "buffer" && now?.lock !== void 0 && /* @__PURE__ */ a(Fact, {
				name: t("lock_for"),
				children: lockOf(now)
			}),
			now?.pending && /* @__PURE__ */ a(Fact, {
				name: t("pending"),
				children: now.pending
			}),
			barcode && /* @__PURE__ */ a(Fact, {
				name: t("barcode"),
				children: barcode
			}),
			now?.link && /* @__PURE__ */ a(Fact, {
				name: t("on_line"),
				children: t("line_number", now.link, now.number ?? "")
			}),
			kind !== "charger" && !now?.fresh && /* @__PURE__ */ a(Fact, {
				name: t("seen"),
				children: now?.seen ? t("ago", span(serverNow() - Date.parse(now.seen))) : "–"
			})
		] }),
		/* @__PURE__ */ a(Commands, {
			id,
			commands: COMMANDS[kind]
		}),
		now && /* @__PURE__ */ a(DeviceDecisions, { device: now }),
		now && kind !== "charger" && /* @__PURE__ */ a(DeviceMore, { device: now })
	] });
}
function State({ look, device }) {
	const last = device && !device.fresh && device.state ? t("last_word", t(`device_${stateOf(device.state)}`)) : "";
	return /* @__PURE__ */ a($, { children: [
		/* @__PURE__ */ a("b", {
			style: { color: DEVICE_LOOKS[look] },
			children: t(`device_${look}`)
		}),
		device?.since && device.fresh && /* @__PURE__ */ a("small", { children: [" · ", t("since", clock(device.since))] }),
		last && /* @__PURE__ */ a("small", { children: [" · ", last] })
	] });
}
var STATES$1 = /* @__PURE__ */ new Set([
	"open",
	"closed",
	"cart",
	"no_cart",
	"busy",
	"error"
]);
var stateOf = (word) => STATES$1.has(word) ? word : "unknown";
function lockOf(device) {
	const { lock } = device;
	if (!lock) return t("not_locked");
	return /* @__PURE__ */ a($, { children: [
		lock.owner,
		" ",
		/* @__PURE__ */ a("small", { children: ["· ", lock.locked === null ? t("lock_unsure") : t("since", clock(lock.since))] })
	] });
}
function Vehicles$1({ ids }) {
	if (ids.length === 0) return /* @__PURE__ */ a($, { children: t("nobody") });
	return /* @__PURE__ */ a("span", {
		class: "names",
		children: ids.map((id) => /* @__PURE__ */ a("button", {
			type: "button",
			class: "text",
			onClick: () => selected.value = {
				kind: "vehicle",
				id
			},
			children: id
		}, id))
	});
}
function Notes$2({ device }) {
	const { lockout, pin } = device;
	return /* @__PURE__ */ a($, { children: [
		device.alarm && /* @__PURE__ */ a("p", {
			class: "note alarm",
			children: [
				/* @__PURE__ */ a("b", { children: tell(device.alarm) }),
				" ",
				device.remedy && /* @__PURE__ */ a("em", { children: tell(device.remedy) })
			]
		}),
		!device.fresh && device.reason && !device.alarm && device.kind !== "charger" && /* @__PURE__ */ a("p", {
			class: "note held",
			children: [
				/* @__PURE__ */ a("b", { children: t("device_silent") }),
				" ",
				tell(device.reason)
			]
		}),
		device.contradiction && /* @__PURE__ */ a("p", {
			class: "note held",
			children: [
				/* @__PURE__ */ a("b", { children: t("contradicts") }),
				" ",
				tell(device.contradiction)
			]
		}),
		lockout && /* @__PURE__ */ a("p", {
			class: "note held",
			children: [
				/* @__PURE__ */ a("b", { children: t("locked", lockout.owner) }),
				" ",
				lockout.reason
			]
		}),
		device.out_of_service && /* @__PURE__ */ a("p", {
			class: "note held",
			children: [
				/* @__PURE__ */ a("b", { children: t("out_of_service") }),
				" ",
				device.out_of_service
			]
		}),
		pin && /* @__PURE__ */ a("p", {
			class: "note waits",
			children: [
				/* @__PURE__ */ a("b", { children: t("pinned", t(pin.position === "open" ? "device_open" : "device_closed"), pin.owner) }),
				" ",
				pin.reason
			]
		})
	] });
}
function Commands({ id, commands }) {
	const error = useSignal(null);
	const done = useSignal("");
	const now = deviceNow(id);
	if (commands.length === 0) return null;
	const send = (command) => {
		error.value = null;
		done.value = "";
		post(`/devices/${encodeURIComponent(id)}/commands`, { command }).then(() => done.value = t("asked", t(`cmd_${command}`)), (failure) => error.value = failure);
	};
	return /* @__PURE__ */ a($, { children: [
		/* @__PURE__ */ a("div", {
			class: "buttons",
			"data-commands": id,
			children: commands.map((command) => /* @__PURE__ */ a(Sure, {
				needs: "POST /devices/{device}/commands",
				label: t(`cmd_${command}`),
				does: () => send(command),
				...stopped(againstDevice(now, command))
			}, command))
		}),
		/* @__PURE__ */ a(Problem, { error: error.value }),
		done.value && /* @__PURE__ */ a("span", {
			class: "done",
			role: "status",
			children: done.value
		})
	] });
}
// src/parts/BackupContents.tsx
/** What a backup of a drive has: each parameter raw, and in its unit where the model's catalogue names it. */
function BackupContents({ path }) {
	const open = useSignal(false);
	const { value, error } = useRead(open.value ? path : null);
	return /* @__PURE__ */ a("details", {
		class: "contents",
		open: open.value,
		onToggle: (event) => open.value = event.currentTarget.open,
		children: [
			/* @__PURE__ */ a("summary", { children: t("backup_contents") }),
			/* @__PURE__ */ a(Problem, { error }),
			value && /* @__PURE__ */ a("table", {
				class: "bits",
				children: /* @__PURE__ */ a("tbody", { children: value.values.map((row) => /* @__PURE__ */ a("tr", { children: [
					/* @__PURE__ */ a("th", { children: row.parameter }),
					/* @__PURE__ */ a("td", { children: row.raw }),
					/* @__PURE__ */ a("td", { children: [
						tell(row.name),
						" ",
						row.value !== null && `${row.value} ${row.unit}`
					] })
				] }, row.parameter)) })
			})
		]
	});
}
// src/parts/DriveCatalogue.tsx
/** What is known of a drive's model, parameter by parameter; read once somebody opens it. */
function DriveCatalogue({ path }) {
	const open = useSignal(false);
	const { value, error } = useRead(open.value ? `${path}/catalogue` : null);
	return /* @__PURE__ */ a("details", {
		class: "part acts",
		open: open.value,
		onToggle: (event) => open.value = event.currentTarget.open,
		children: [
			/* @__PURE__ */ a("summary", { children: [
				t("catalogue"),
				" ",
				value?.model
			] }),
			/* @__PURE__ */ a(Problem, { error }),
			value?.description && /* @__PURE__ */ a("p", {
				class: "calm",
				children: tell(value.description)
			}),
			value?.parameters.length === 0 && /* @__PURE__ */ a("p", {
				class: "nothing",
				children: t("no_catalogue")
			}),
			value && value.parameters.length > 0 && /* @__PURE__ */ a("div", {
				class: "scroll wide-table",
				tabIndex: 0,
				role: "group",
				"aria-label": t("catalogue"),
				children: /* @__PURE__ */ a("table", {
					class: "list",
					children: [/* @__PURE__ */ a("thead", { children: /* @__PURE__ */ a("tr", { children: [
						"#",
						t("name"),
						t("range"),
						t("default_value")
					].map((name) => /* @__PURE__ */ a("th", { children: /* @__PURE__ */ a("span", { children: name }) }, name)) }) }), /* @__PURE__ */ a("tbody", { children: value.parameters.map((spec) => /* @__PURE__ */ a("tr", {
						"data-spec": spec.number,
						children: [
							/* @__PURE__ */ a("td", { children: spec.number }),
							/* @__PURE__ */ a("td", { children: [
								tell(spec.name),
								" ",
								/* @__PURE__ */ a("small", {
									class: "calm basis",
									children: wordsOf(spec)
								})
							] }),
							/* @__PURE__ */ a("td", { children: rangeOf(spec) }),
							/* @__PURE__ */ a("td", { children: spec.default ?? "–" })
						]
					}, spec.number)) })]
				})
			})
		]
	});
}
function rangeOf({ lowest, highest, unit }) {
	return `${lowest ?? ""} … ${highest ?? ""} ${unit}`.trim();
}
function wordsOf(spec) {
	const choices = Object.entries(spec.choices).map(([raw, word]) => `${raw}: ${tell(word)}`);
	return [
		tell(spec.description),
		choices.join(", "),
		spec.read_only ? t("read_only") : spec.while_running ? t("while_running") : ""
	].filter(Boolean).join(" · ");
}
// src/parts/Parameters.tsx
/** A drive's parameters as last known, and how they are read from it. */
/** How an operation stands: done, under way, or why not. */
function Outcome({ operation, label }) {
	if (!operation) return null;
	if (operation.state === "failed" || operation.state === "unknown") return /* @__PURE__ */ a("div", {
		class: "problem",
		role: "alert",
		children: [/* @__PURE__ */ a("b", { children: tell(operation.reason) || t("op_unknown") }), operation.remedy && /* @__PURE__ */ a("span", { children: tell(operation.remedy) })]
	});
	return /* @__PURE__ */ a("span", {
		class: operation.state === "done" ? "done" : "wait",
		role: "status",
		children: t(operation.state === "done" ? "op_done" : "op_running", label)
	});
}
function Parameters({ drive }) {
	const { id } = drive;
	const list = useSignal(null);
	const operation = useSignal(null);
	const error = useSignal(null);
	const here = T(true);
	const path = `/drives/${encodeURIComponent(id)}/parameters`;
	const refresh = async () => {
		try {
			list.value = (await get(path)).items;
		} catch {}
	};
	A$1(() => {
		here.current = true;
		refresh();
		return () => {
			here.current = false;
		};
	}, [id]);
	const named = list.value?.filter((parameter) => parameter.named).map((parameter) => parameter.number) ?? [];
	const read = async () => {
		error.value = null;
		try {
			let now = await post(`/drives/${encodeURIComponent(id)}/read`, named.length ? { parameters: named } : {});
			operation.value = now;
			while (now.state === "running" && here.current) {
				now = await get(`/operations/${encodeURIComponent(now.id)}?wait=1`);
				operation.value = now;
				await refresh();
			}
		} catch (failure) {
			error.value = failure;
		}
	};
	const running = operation.value?.state === "running";
	const known = list.value?.filter((parameter) => parameter.named || parameter.raw !== null) ?? [];
	return /* @__PURE__ */ a("section", {
		class: "part",
		children: [
			/* @__PURE__ */ a("h3", { children: [
				t("parameters"),
				operation.value && running && /* @__PURE__ */ a("small", { children: t("reading", operation.value.done, operation.value.total) }),
				/* @__PURE__ */ a(Button, {
					needs: "POST /drives/{drive}/read",
					disabled: running,
					onClick: () => void read(),
					...stopped(againstDrive(drive, "read", around())),
					children: t("read_parameters")
				})
			] }),
			/* @__PURE__ */ a(Problem, { error: error.value }),
			!running && /* @__PURE__ */ a(Outcome, {
				operation: operation.value,
				label: t("read_parameters")
			}),
			known.length === 0 && /* @__PURE__ */ a("p", {
				class: "nothing",
				children: t("no_parameters")
			}),
			/* @__PURE__ */ a("table", {
				class: "bits numbered",
				children: /* @__PURE__ */ a("tbody", { children: known.map((parameter) => /* @__PURE__ */ a("tr", {
					title: tell(parameter.description),
					children: [
						/* @__PURE__ */ a("th", { children: parameter.number }),
						/* @__PURE__ */ a("td", { children: parameter.raw === null ? "–" : tell(parameter.text) }),
						/* @__PURE__ */ a("td", { children: [
							tell(parameter.name),
							" ",
							parameter.at && /* @__PURE__ */ a("small", { children: ["· ", clock(parameter.at)] }),
							parameter.named && !parameter.read_only && parameter.raw !== null && /* @__PURE__ */ a(Write, {
								path: `${path}/${parameter.number}`,
								parameter,
								after: refresh,
								against: againstDrive(drive, "change", around())
							})
						] })
					]
				}, parameter.number)) })
			})
		]
	});
}
/** A new value, in the catalogue's unit; written only if the drive still has what is shown, and read back. */
function Write({ path, parameter, after, against }) {
	const value = useSignal(parameter.value === null ? "" : String(parameter.value));
	const operation = useSignal(null);
	const error = useSignal(null);
	const write = async () => {
		error.value = operation.value = null;
		try {
			operation.value = await call("PUT", `${path}?wait=10`, { value: Number(value.value) }, { "If-Match": `"${parameter.raw}"` });
			await after();
		} catch (failure) {
			error.value = failure;
		}
	};
	const range = parameter.lowest === null ? "" : `${parameter.lowest} … ${parameter.highest ?? ""} ${parameter.unit}`;
	return /* @__PURE__ */ a("details", {
		class: "write",
		children: [
			/* @__PURE__ */ a("summary", { children: t("write") }),
			/* @__PURE__ */ a("div", {
				class: "acts-row",
				children: [
					/* @__PURE__ */ a("input", {
						"aria-label": `${parameter.number} ${tell(parameter.name)}`,
						title: range,
						placeholder: range,
						value: value.value,
						onInput: (event) => value.value = event.currentTarget.value
					}),
					/* @__PURE__ */ a(Sure, {
						needs: "PUT /drives/{drive}/parameters/{number}",
						label: t("write"),
						disabled: value.value.trim() === "" || Number.isNaN(Number(value.value)),
						does: () => void write(),
						...stopped(against)
					}),
					/* @__PURE__ */ a("small", {
						class: "calm",
						children: range
					})
				]
			}),
			/* @__PURE__ */ a(Problem, { error: error.value }),
			/* @__PURE__ */ a(Outcome, {
				operation: operation.value,
				label: t("write")
			})
		]
	});
}
// src/parts/DriveMore.tsx
/** A drive's status asked for now, its inputs, what was asked of it lately, and the packets on its line. */
function DriveMore({ drive, path }) {
	return /* @__PURE__ */ a($, { children: [
		/* @__PURE__ */ a(Inputs, {
			path,
			drive
		}),
		/* @__PURE__ */ a(Operations, {
			path,
			drive
		}),
		/* @__PURE__ */ a(LineFrames, { path: `${path}/frames` })
	] });
}
var INPUTS = ["run", "home"];
/** What is not named is off: one press sets one of them, or none. */
function Inputs({ path, drive }) {
	const asking = useAsking();
	const operation = useSignal(null);
	const label = useSignal("");
	const ask = (words, what) => {
		label.value = words;
		operation.value = null;
		asking.ask(async () => {
			operation.value = await what();
		}, "");
	};
	return /* @__PURE__ */ a("details", {
		class: "part acts",
		children: [/* @__PURE__ */ a("summary", { children: t("inputs") }), /* @__PURE__ */ a("div", {
			class: "stack",
			children: [
				/* @__PURE__ */ a("div", {
					class: "acts-row",
					children: [
						/* @__PURE__ */ a(Button, {
							needs: "POST /drives/{drive}/status",
							onClick: () => ask(t("ask_status"), () => post(`${path}/status?wait=5`)),
							...stopped(againstDrive(drive, "harmless", around())),
							children: t("ask_status")
						}),
						INPUTS.map((name) => /* @__PURE__ */ a(Sure, {
							needs: "PUT /drives/{drive}/inputs",
							label: t(`input_${name}`),
							does: () => ask(t(`input_${name}`), () => call("PUT", `${path}/inputs?wait=5`, { [name]: true })),
							...stopped(againstDrive(drive, "move", around()))
						}, name)),
						/* @__PURE__ */ a(Button, {
							needs: "PUT /drives/{drive}/inputs",
							onClick: () => ask(t("inputs_off"), () => call("PUT", `${path}/inputs?wait=5`, {})),
							...stopped(againstDrive(drive, "change", around())),
							children: t("inputs_off")
						})
					]
				}),
				/* @__PURE__ */ a(Told, { asking }),
				/* @__PURE__ */ a(Outcome, {
					operation: operation.value,
					label: label.value
				})
			]
		})]
	});
}
/** Each ended done, failed, or unknown; what still runs can be cancelled. */
function Operations({ path, drive }) {
	const open = useSignal(false);
	const again = useSignal(0);
	const asking = useAsking();
	const { value } = useRead(open.value ? `${path}/operations?limit=20` : null, drive.operation, again.value, Math.floor(changes.drives.value / 20));
	const cancel = async (id) => {
		await asking.ask(() => post(`/operations/${encodeURIComponent(id)}/cancel`));
		again.value++;
	};
	return /* @__PURE__ */ a("details", {
		class: "part acts",
		open: open.value,
		onToggle: (event) => open.value = event.currentTarget.open,
		children: [
			/* @__PURE__ */ a("summary", { children: t("operations") }),
			/* @__PURE__ */ a(Told, { asking }),
			value?.items.length === 0 && /* @__PURE__ */ a("p", {
				class: "nothing",
				children: t("no_operations")
			}),
			/* @__PURE__ */ a("table", {
				class: "bits",
				children: /* @__PURE__ */ a("tbody", { children: value?.items.map((one) => /* @__PURE__ */ a("tr", {
					"data-operation": one.id,
					children: [
						/* @__PURE__ */ a("th", { children: ["#", one.id] }),
						/* @__PURE__ */ a("td", {
							class: one.state === "done" ? "good" : one.state === "running" ? "wait" : "bad",
							children: said$1(`op_state_${one.state}`)
						}),
						/* @__PURE__ */ a("td", { children: [
							said$1(one.kind),
							" · ",
							one.actor,
							" · ",
							moment$1(one.opened),
							" ",
							one.reason && ` · ${tell(one.reason)}`,
							one.state === "running" && /* @__PURE__ */ a(Sure, {
								needs: "POST /operations/{operation}/cancel",
								label: t("cancel"),
								does: () => void cancel(one.id)
							})
						] })
					]
				}, one.id)) })
			})
		]
	});
}
// node_modules/uplot/dist/uPlot.esm.js
/**
* Copyright (c) 2025, Leon Sorokin
* All rights reserved. (MIT Licensed)
*
* uPlot.js (μPlot)
* A small, fast chart for time series, lines, areas, ohlc & bars
* github.com/leeoniya/uPlot (v1.6.32)
*/
var FEAT_TIME = true;
var UPLOT = "uplot";
var ORI_HZ = "u-hz";
var ORI_VT = "u-vt";
var TITLE = "u-title";
var WRAP = "u-wrap";
var UNDER = "u-under";
var OVER$1 = "u-over";
var AXIS = "u-axis";
var OFF = "u-off";
var SELECT = "u-select";
var CURSOR_X = "u-cursor-x";
var CURSOR_Y = "u-cursor-y";
var CURSOR_PT = "u-cursor-pt";
var LEGEND = "u-legend";
var LEGEND_LIVE = "u-live";
var LEGEND_INLINE = "u-inline";
var LEGEND_SERIES = "u-series";
var LEGEND_MARKER = "u-marker";
var LEGEND_LABEL = "u-label";
var LEGEND_VALUE = "u-value";
var WIDTH = "width";
var HEIGHT$2 = "height";
var TOP = "top";
var BOTTOM = "bottom";
var LEFT = "left";
var RIGHT = "right";
var hexBlack = "#000";
var transparent = "#0000";
var mousemove = "mousemove";
var mousedown = "mousedown";
var mouseup = "mouseup";
var mouseenter = "mouseenter";
var mouseleave = "mouseleave";
var dblclick = "dblclick";
var resize = "resize";
var scroll = "scroll";
var change = "change";
var dppxchange = "dppxchange";
var LEGEND_DISP = "--";
var domEnv = typeof window != "undefined";
var doc = domEnv ? document : null;
var win = domEnv ? window : null;
var nav = domEnv ? navigator : null;
var pxRatio;
var query;
function setPxRatio() {
	let _pxRatio = devicePixelRatio;
	if (pxRatio != _pxRatio) {
		pxRatio = _pxRatio;
		query && off(change, query, setPxRatio);
		query = matchMedia(`(min-resolution: ${pxRatio - .001}dppx) and (max-resolution: ${pxRatio + .001}dppx)`);
		on(change, query, setPxRatio);
		win.dispatchEvent(new CustomEvent(dppxchange));
	}
}
function addClass(el, c) {
	if (c != null) {
		let cl = el.classList;
		!cl.contains(c) && cl.add(c);
	}
}
function remClass(el, c) {
	let cl = el.classList;
	cl.contains(c) && cl.remove(c);
}
function setStylePx(el, name, value) {
	el.style[name] = value + "px";
}
function placeTag(tag, cls, targ, refEl) {
	let el = doc.createElement(tag);
	if (cls != null) addClass(el, cls);
	if (targ != null) targ.insertBefore(el, refEl);
	return el;
}
function placeDiv(cls, targ) {
	return placeTag("div", cls, targ);
}
var xformCache = /* @__PURE__ */ new WeakMap();
function elTrans(el, xPos, yPos, xMax, yMax) {
	let xform = "translate(" + xPos + "px," + yPos + "px)";
	if (xform != xformCache.get(el)) {
		el.style.transform = xform;
		xformCache.set(el, xform);
		if (xPos < 0 || yPos < 0 || xPos > xMax || yPos > yMax) addClass(el, OFF);
		else remClass(el, OFF);
	}
}
var colorCache = /* @__PURE__ */ new WeakMap();
function elColor(el, background, borderColor) {
	let newColor = background + borderColor;
	if (newColor != colorCache.get(el)) {
		colorCache.set(el, newColor);
		el.style.background = background;
		el.style.borderColor = borderColor;
	}
}
var sizeCache = /* @__PURE__ */ new WeakMap();
function elSize(el, newWid, newHgt, centered) {
	let newSize = newWid + "" + newHgt;
	if (newSize != sizeCache.get(el)) {
		sizeCache.set(el, newSize);
		el.style.height = newHgt + "px";
		el.style.width = newWid + "px";
		el.style.marginLeft = centered ? -newWid / 2 + "px" : 0;
		el.style.marginTop = centered ? -newHgt / 2 + "px" : 0;
	}
}
var evOpts = { passive: true };
var evOpts2 = {
	...evOpts,
	capture: true
};
function on(ev, el, cb, capt) {
	el.addEventListener(ev, cb, capt ? evOpts2 : evOpts);
}
function off(ev, el, cb, capt) {
	el.removeEventListener(ev, cb, evOpts);
}
domEnv && setPxRatio();
function closestIdx(num, arr, lo, hi) {
	let mid;
	lo = lo || 0;
	hi = hi || arr.length - 1;
	let bitwise = hi <= 2147483647;
	while (hi - lo > 1) {
		mid = bitwise ? lo + hi >> 1 : floor((lo + hi) / 2);
		if (arr[mid] < num) lo = mid;
		else hi = mid;
	}
	if (num - arr[lo] <= arr[hi] - num) return lo;
	return hi;
}
function makeIndexOfs(predicate) {
	let indexOfs = (data, _i0, _i1) => {
		let i0 = -1;
		let i1 = -1;
		for (let i = _i0; i <= _i1; i++) if (predicate(data[i])) {
			i0 = i;
			break;
		}
		for (let i = _i1; i >= _i0; i--) if (predicate(data[i])) {
			i1 = i;
			break;
		}
		return [i0, i1];
	};
	return indexOfs;
}
var notNullish = (v) => v != null;
var isPositive = (v) => v != null && v > 0;
var nonNullIdxs = makeIndexOfs(notNullish);
var positiveIdxs = makeIndexOfs(isPositive);
function getMinMax(data, _i0, _i1, sorted = 0, log = false) {
	let getEdgeIdxs = log ? positiveIdxs : nonNullIdxs;
	let predicate = log ? isPositive : notNullish;
	[_i0, _i1] = getEdgeIdxs(data, _i0, _i1);
	let _min = data[_i0];
	let _max = data[_i0];
	if (_i0 > -1) {
		if (sorted == 1) {
			_min = data[_i0];
			_max = data[_i1];
		} else if (sorted == -1) {
			_min = data[_i1];
			_max = data[_i0];
		} else for (let i = _i0; i <= _i1; i++) {
			let v = data[i];
			if (predicate(v)) {
				if (v < _min) _min = v;
				else if (v > _max) _max = v;
			}
		}
	}
	return [_min ?? inf, _max ?? -inf];
}
function rangeLog(min, max, base, fullMags) {
	let minSign = sign(min);
	let maxSign = sign(max);
	if (min == max) {
		if (minSign == -1) {
			min *= base;
			max /= base;
		} else {
			min /= base;
			max *= base;
		}
	}
	let logFn = base == 10 ? log10 : log2;
	let growMinAbs = minSign == 1 ? floor : ceil;
	let growMaxAbs = maxSign == 1 ? ceil : floor;
	let minExp = growMinAbs(logFn(abs(min)));
	let maxExp = growMaxAbs(logFn(abs(max)));
	let minIncr = pow(base, minExp);
	let maxIncr = pow(base, maxExp);
	if (base == 10) {
		if (minExp < 0) minIncr = roundDec(minIncr, -minExp);
		if (maxExp < 0) maxIncr = roundDec(maxIncr, -maxExp);
	}
	if (fullMags || base == 2) {
		min = minIncr * minSign;
		max = maxIncr * maxSign;
	} else {
		min = incrRoundDn(min, minIncr);
		max = incrRoundUp(max, maxIncr);
	}
	return [min, max];
}
function rangeAsinh(min, max, base, fullMags) {
	let minMax = rangeLog(min, max, base, fullMags);
	if (min == 0) minMax[0] = 0;
	if (max == 0) minMax[1] = 0;
	return minMax;
}
var rangePad = .1;
var autoRangePart = {
	mode: 3,
	pad: rangePad
};
var _eqRangePart = {
	pad: 0,
	soft: null,
	mode: 0
};
var _eqRange = {
	min: _eqRangePart,
	max: _eqRangePart
};
function rangeNum(_min, _max, mult, extra) {
	if (isObj(mult)) return _rangeNum(_min, _max, mult);
	_eqRangePart.pad = mult;
	_eqRangePart.soft = extra ? 0 : null;
	_eqRangePart.mode = extra ? 3 : 0;
	return _rangeNum(_min, _max, _eqRange);
}
function ifNull(lh, rh) {
	return lh == null ? rh : lh;
}
function hasData(data, idx0, idx1) {
	idx0 = ifNull(idx0, 0);
	idx1 = ifNull(idx1, data.length - 1);
	while (idx0 <= idx1) {
		if (data[idx0] != null) return true;
		idx0++;
	}
	return false;
}
function _rangeNum(_min, _max, cfg) {
	let cmin = cfg.min;
	let cmax = cfg.max;
	let padMin = ifNull(cmin.pad, 0);
	let padMax = ifNull(cmax.pad, 0);
	let hardMin = ifNull(cmin.hard, -inf);
	let hardMax = ifNull(cmax.hard, inf);
	let softMin = ifNull(cmin.soft, inf);
	let softMax = ifNull(cmax.soft, -inf);
	let softMinMode = ifNull(cmin.mode, 0);
	let softMaxMode = ifNull(cmax.mode, 0);
	let delta = _max - _min;
	let deltaMag = log10(delta);
	let scalarMax = max(abs(_min), abs(_max));
	let scalarMagDelta = abs(log10(scalarMax) - deltaMag);
	if (delta < 1e-24 || scalarMagDelta > 10) {
		delta = 0;
		if (_min == 0 || _max == 0) {
			delta = 1e-24;
			if (softMinMode == 2 && softMin != inf) padMin = 0;
			if (softMaxMode == 2 && softMax != -inf) padMax = 0;
		}
	}
	let nonZeroDelta = delta || scalarMax || 1e3;
	let base = pow(10, floor(log10(nonZeroDelta)));
	let _newMin = roundDec(incrRoundDn(_min - nonZeroDelta * (delta == 0 ? _min == 0 ? .1 : 1 : padMin), base / 10), 24);
	let _softMin = _min >= softMin && (softMinMode == 1 || softMinMode == 3 && _newMin <= softMin || softMinMode == 2 && _newMin >= softMin) ? softMin : inf;
	let minLim = max(hardMin, _newMin < _softMin && _min >= _softMin ? _softMin : min(_softMin, _newMin));
	let _newMax = roundDec(incrRoundUp(_max + nonZeroDelta * (delta == 0 ? _max == 0 ? .1 : 1 : padMax), base / 10), 24);
	let _softMax = _max <= softMax && (softMaxMode == 1 || softMaxMode == 3 && _newMax >= softMax || softMaxMode == 2 && _newMax <= softMax) ? softMax : -inf;
	let maxLim = min(hardMax, _newMax > _softMax && _max <= _softMax ? _softMax : max(_softMax, _newMax));
	if (minLim == maxLim && minLim == 0) maxLim = 100;
	return [minLim, maxLim];
}
var numFormatter = new Intl.NumberFormat(domEnv ? nav.language : "en-US");
var fmtNum = (val) => numFormatter.format(val);
var M = Math;
var PI = M.PI;
var abs = M.abs;
var floor = M.floor;
var round$1 = M.round;
var ceil = M.ceil;
var min = M.min;
var max = M.max;
var pow = M.pow;
var sign = M.sign;
var log10 = M.log10;
var log2 = M.log2;
var sinh = (v, linthresh = 1) => M.sinh(v) * linthresh;
var asinh = (v, linthresh = 1) => M.asinh(v / linthresh);
var inf = Infinity;
function numIntDigits(x) {
	return (log10((x ^ x >> 31) - (x >> 31)) | 0) + 1;
}
function clamp(num, _min, _max) {
	return min(max(num, _min), _max);
}
function isFn(v) {
	return typeof v == "function";
}
function fnOrSelf(v) {
	return isFn(v) ? v : () => v;
}
var noop = () => {};
var retArg0 = (_0) => _0;
var retArg1 = (_0, _1) => _1;
var retNull = (_) => null;
var retTrue = (_) => true;
var retEq = (a, b) => a == b;
var regex6 = /\.\d*?(?=9{6,}|0{6,})/gm;
var fixFloat = (val) => {
	if (isInt(val) || fixedDec.has(val)) return val;
	const str = `${val}`;
	const match = str.match(regex6);
	if (match == null) return val;
	let len = match[0].length - 1;
	if (str.indexOf("e-") != -1) {
		let [num, exp] = str.split("e");
		return +`${fixFloat(num)}e${exp}`;
	}
	return roundDec(val, len);
};
function incrRound(num, incr) {
	return fixFloat(roundDec(fixFloat(num / incr)) * incr);
}
function incrRoundUp(num, incr) {
	return fixFloat(ceil(fixFloat(num / incr)) * incr);
}
function incrRoundDn(num, incr) {
	return fixFloat(floor(fixFloat(num / incr)) * incr);
}
function roundDec(val, dec = 0) {
	if (isInt(val)) return val;
	let p = 10 ** dec;
	return round$1(val * p * (1 + Number.EPSILON)) / p;
}
var fixedDec = /* @__PURE__ */ new Map();
function guessDec(num) {
	return (("" + num).split(".")[1] || "").length;
}
function genIncrs(base, minExp, maxExp, mults) {
	let incrs = [];
	let multDec = mults.map(guessDec);
	for (let exp = minExp; exp < maxExp; exp++) {
		let expa = abs(exp);
		let mag = roundDec(pow(base, exp), expa);
		for (let i = 0; i < mults.length; i++) {
			let _incr = base == 10 ? +`${mults[i]}e${exp}` : mults[i] * mag;
			let dec = (exp >= 0 ? 0 : expa) + (exp >= multDec[i] ? 0 : multDec[i]);
			let incr = base == 10 ? _incr : roundDec(_incr, dec);
			incrs.push(incr);
			fixedDec.set(incr, dec);
		}
	}
	return incrs;
}
var EMPTY_OBJ = {};
var EMPTY_ARR = [];
var nullNullTuple = [null, null];
var isArr = Array.isArray;
var isInt = Number.isInteger;
var isUndef = (v) => v === void 0;
function isStr(v) {
	return typeof v == "string";
}
function isObj(v) {
	let is = false;
	if (v != null) {
		let c = v.constructor;
		is = c == null || c == Object;
	}
	return is;
}
function fastIsObj(v) {
	return v != null && typeof v == "object";
}
var TypedArray = Object.getPrototypeOf(Uint8Array);
var __proto__ = "__proto__";
function copy(o, _isObj = isObj) {
	let out;
	if (isArr(o)) {
		let val = o.find((v) => v != null);
		if (isArr(val) || _isObj(val)) {
			out = Array(o.length);
			for (let i = 0; i < o.length; i++) out[i] = copy(o[i], _isObj);
		} else out = o.slice();
	} else if (o instanceof TypedArray) out = o.slice();
	else if (_isObj(o)) {
		out = {};
		for (let k in o) if (k != __proto__) out[k] = copy(o[k], _isObj);
	} else out = o;
	return out;
}
function assign(targ) {
	let args = arguments;
	for (let i = 1; i < args.length; i++) {
		let src = args[i];
		for (let key in src) if (key != __proto__) {
			if (isObj(targ[key])) assign(targ[key], copy(src[key]));
			else targ[key] = copy(src[key]);
		}
	}
	return targ;
}
var NULL_REMOVE = 0;
var NULL_RETAIN = 1;
var NULL_EXPAND = 2;
function nullExpand(yVals, nullIdxs, alignedLen) {
	for (let i = 0, xi, lastNullIdx = -1; i < nullIdxs.length; i++) {
		let nullIdx = nullIdxs[i];
		if (nullIdx > lastNullIdx) {
			xi = nullIdx - 1;
			while (xi >= 0 && yVals[xi] == null) yVals[xi--] = null;
			xi = nullIdx + 1;
			while (xi < alignedLen && yVals[xi] == null) yVals[lastNullIdx = xi++] = null;
		}
	}
}
function join(tables, nullModes) {
	if (allHeadersSame(tables)) {
		let table = tables[0].slice();
		for (let i = 1; i < tables.length; i++) table.push(...tables[i].slice(1));
		if (!isAsc(table[0])) table = sortCols(table);
		return table;
	}
	let xVals = /* @__PURE__ */ new Set();
	for (let ti = 0; ti < tables.length; ti++) {
		let xs = tables[ti][0];
		let len = xs.length;
		for (let i = 0; i < len; i++) xVals.add(xs[i]);
	}
	let data = [Array.from(xVals).sort((a, b) => a - b)];
	let alignedLen = data[0].length;
	let xIdxs = /* @__PURE__ */ new Map();
	for (let i = 0; i < alignedLen; i++) xIdxs.set(data[0][i], i);
	for (let ti = 0; ti < tables.length; ti++) {
		let t = tables[ti];
		let xs = t[0];
		for (let si = 1; si < t.length; si++) {
			let ys = t[si];
			let yVals = Array(alignedLen).fill(void 0);
			let nullMode = nullModes ? nullModes[ti][si] : NULL_RETAIN;
			let nullIdxs = [];
			for (let i = 0; i < ys.length; i++) {
				let yVal = ys[i];
				let alignedIdx = xIdxs.get(xs[i]);
				if (yVal === null) {
					if (nullMode != NULL_REMOVE) {
						yVals[alignedIdx] = yVal;
						if (nullMode == NULL_EXPAND) nullIdxs.push(alignedIdx);
					}
				} else yVals[alignedIdx] = yVal;
			}
			nullExpand(yVals, nullIdxs, alignedLen);
			data.push(yVals);
		}
	}
	return data;
}
var microTask = typeof queueMicrotask == "undefined" ? (fn) => Promise.resolve().then(fn) : queueMicrotask;
function sortCols(table) {
	let head = table[0];
	let rlen = head.length;
	let idxs = Array(rlen);
	for (let i = 0; i < idxs.length; i++) idxs[i] = i;
	idxs.sort((i0, i1) => head[i0] - head[i1]);
	let table2 = [];
	for (let i = 0; i < table.length; i++) {
		let row = table[i];
		let row2 = Array(rlen);
		for (let j = 0; j < rlen; j++) row2[j] = row[idxs[j]];
		table2.push(row2);
	}
	return table2;
}
function allHeadersSame(tables) {
	let vals0 = tables[0][0];
	let len0 = vals0.length;
	for (let i = 1; i < tables.length; i++) {
		let vals1 = tables[i][0];
		if (vals1.length != len0) return false;
		if (vals1 != vals0) {
			for (let j = 0; j < len0; j++) if (vals1[j] != vals0[j]) return false;
		}
	}
	return true;
}
function isAsc(vals, samples = 100) {
	const len = vals.length;
	if (len <= 1) return true;
	let firstIdx = 0;
	let lastIdx = len - 1;
	while (firstIdx <= lastIdx && vals[firstIdx] == null) firstIdx++;
	while (lastIdx >= firstIdx && vals[lastIdx] == null) lastIdx--;
	if (lastIdx <= firstIdx) return true;
	const stride = max(1, floor((lastIdx - firstIdx + 1) / samples));
	for (let prevVal = vals[firstIdx], i = firstIdx + stride; i <= lastIdx; i += stride) {
		const v = vals[i];
		if (v != null) {
			if (v <= prevVal) return false;
			prevVal = v;
		}
	}
	return true;
}
var months = [
	"January",
	"February",
	"March",
	"April",
	"May",
	"June",
	"July",
	"August",
	"September",
	"October",
	"November",
	"December"
];
var days = [
	"Sunday",
	"Monday",
	"Tuesday",
	"Wednesday",
	"Thursday",
	"Friday",
	"Saturday"
];
function slice3(str) {
	return str.slice(0, 3);
}
var days3 = days.map(slice3);
var engNames = {
	MMMM: months,
	MMM: months.map(slice3),
	WWWW: days,
	WWW: days3
};
function zeroPad2(int) {
	return (int < 10 ? "0" : "") + int;
}
function zeroPad3(int) {
	return (int < 10 ? "00" : int < 100 ? "0" : "") + int;
}
var subs = {
	YYYY: (d) => d.getFullYear(),
	YY: (d) => (d.getFullYear() + "").slice(2),
	MMMM: (d, names) => names.MMMM[d.getMonth()],
	MMM: (d, names) => names.MMM[d.getMonth()],
	MM: (d) => zeroPad2(d.getMonth() + 1),
	M: (d) => d.getMonth() + 1,
	DD: (d) => zeroPad2(d.getDate()),
	D: (d) => d.getDate(),
	WWWW: (d, names) => names.WWWW[d.getDay()],
	WWW: (d, names) => names.WWW[d.getDay()],
	HH: (d) => zeroPad2(d.getHours()),
	H: (d) => d.getHours(),
	h: (d) => {
		let h = d.getHours();
		return h == 0 ? 12 : h > 12 ? h - 12 : h;
	},
	AA: (d) => d.getHours() >= 12 ? "PM" : "AM",
	aa: (d) => d.getHours() >= 12 ? "pm" : "am",
	a: (d) => d.getHours() >= 12 ? "p" : "a",
	mm: (d) => zeroPad2(d.getMinutes()),
	m: (d) => d.getMinutes(),
	ss: (d) => zeroPad2(d.getSeconds()),
	s: (d) => d.getSeconds(),
	fff: (d) => zeroPad3(d.getMilliseconds())
};
function fmtDate(tpl, names) {
	names = names || engNames;
	let parts = [];
	let R = /\{([a-z]+)\}|[^{]+/gi, m;
	while (m = R.exec(tpl)) parts.push(m[0][0] == "{" ? subs[m[1]] : m[0]);
	return (d) => {
		let out = "";
		for (let i = 0; i < parts.length; i++) out += typeof parts[i] == "string" ? parts[i] : parts[i](d, names);
		return out;
	};
}
var localTz = new Intl.DateTimeFormat().resolvedOptions().timeZone;
function tzDate(date, tz) {
	let date2;
	if (tz == "UTC" || tz == "Etc/UTC") date2 = /* @__PURE__ */ new Date(+date + date.getTimezoneOffset() * 6e4);
	else if (tz == localTz) date2 = date;
	else {
		date2 = new Date(date.toLocaleString("en-US", { timeZone: tz }));
		date2.setMilliseconds(date.getMilliseconds());
	}
	return date2;
}
var onlyWhole = (v) => v % 1 == 0;
var allMults = [
	1,
	2,
	2.5,
	5
];
var decIncrs = genIncrs(10, -32, 0, allMults);
var oneIncrs = genIncrs(10, 0, 32, allMults);
var wholeIncrs = oneIncrs.filter(onlyWhole);
var numIncrs = decIncrs.concat(oneIncrs);
var NL = "\n";
var yyyy = "{YYYY}";
var NLyyyy = NL + yyyy;
var md = "{M}/{D}";
var NLmd = NL + md;
var NLmdyy = NLmd + "/{YY}";
var aa = "{aa}";
var hmmaa = "{h}:{mm}" + aa;
var NLhmmaa = NL + hmmaa;
var ss = ":{ss}";
var _ = null;
function genTimeStuffs(ms) {
	let s = ms * 1e3, m = s * 60, h = m * 60, d = h * 24, mo = d * 30, y = d * 365;
	let timeIncrs = (ms == 1 ? genIncrs(10, 0, 3, allMults).filter(onlyWhole) : genIncrs(10, -3, 0, allMults)).concat([
		s,
		s * 5,
		s * 10,
		s * 15,
		s * 30,
		m,
		m * 5,
		m * 10,
		m * 15,
		m * 30,
		h,
		h * 2,
		h * 3,
		h * 4,
		h * 6,
		h * 8,
		h * 12,
		d,
		d * 2,
		d * 3,
		d * 4,
		d * 5,
		d * 6,
		d * 7,
		d * 8,
		d * 9,
		d * 10,
		d * 15,
		mo,
		mo * 2,
		mo * 3,
		mo * 4,
		mo * 6,
		y,
		y * 2,
		y * 5,
		y * 10,
		y * 25,
		y * 50,
		y * 100
	]);
	const _timeAxisStamps = [
		[
			y,
			yyyy,
			_,
			_,
			_,
			_,
			_,
			_,
			1
		],
		[
			d * 28,
			"{MMM}",
			NLyyyy,
			_,
			_,
			_,
			_,
			_,
			1
		],
		[
			d,
			md,
			NLyyyy,
			_,
			_,
			_,
			_,
			_,
			1
		],
		[
			h,
			"{h}" + aa,
			NLmdyy,
			_,
			NLmd,
			_,
			_,
			_,
			1
		],
		[
			m,
			hmmaa,
			NLmdyy,
			_,
			NLmd,
			_,
			_,
			_,
			1
		],
		[
			s,
			ss,
			NLmdyy + " " + hmmaa,
			_,
			NLmd + " " + hmmaa,
			_,
			NLhmmaa,
			_,
			1
		],
		[
			ms,
			ss + ".{fff}",
			NLmdyy + " " + hmmaa,
			_,
			NLmd + " " + hmmaa,
			_,
			NLhmmaa,
			_,
			1
		]
	];
	function timeAxisSplits(tzDate) {
		return (self, axisIdx, scaleMin, scaleMax, foundIncr, foundSpace) => {
			let splits = [];
			let isYr = foundIncr >= y;
			let isMo = foundIncr >= mo && foundIncr < y;
			let minDate = tzDate(scaleMin);
			let minDateTs = roundDec(minDate * ms, 3);
			let minMin = mkDate(minDate.getFullYear(), isYr ? 0 : minDate.getMonth(), isMo || isYr ? 1 : minDate.getDate());
			let minMinTs = roundDec(minMin * ms, 3);
			if (isMo || isYr) {
				let moIncr = isMo ? foundIncr / mo : 0;
				let yrIncr = isYr ? foundIncr / y : 0;
				let split = minDateTs == minMinTs ? minDateTs : roundDec(mkDate(minMin.getFullYear() + yrIncr, minMin.getMonth() + moIncr, 1) * ms, 3);
				let splitDate = new Date(round$1(split / ms));
				let baseYear = splitDate.getFullYear();
				let baseMonth = splitDate.getMonth();
				for (let i = 0; split <= scaleMax; i++) {
					let next = mkDate(baseYear + yrIncr * i, baseMonth + moIncr * i, 1);
					let offs = next - tzDate(roundDec(next * ms, 3));
					split = roundDec((+next + offs) * ms, 3);
					if (split <= scaleMax) splits.push(split);
				}
			} else {
				let incr0 = foundIncr >= d ? d : foundIncr;
				let split = minMinTs + (floor(scaleMin) - floor(minDateTs)) + incrRoundUp(minDateTs - minMinTs, incr0);
				splits.push(split);
				let date0 = tzDate(split);
				let prevHour = date0.getHours() + date0.getMinutes() / m + date0.getSeconds() / h;
				let incrHours = foundIncr / h;
				let pctSpace = foundSpace / self.axes[axisIdx]._space;
				while (1) {
					split = roundDec(split + foundIncr, ms == 1 ? 0 : 3);
					if (split > scaleMax) break;
					if (incrHours > 1) {
						let expectedHour = floor(roundDec(prevHour + incrHours, 6)) % 24;
						let dstShift = tzDate(split).getHours() - expectedHour;
						if (dstShift > 1) dstShift = -1;
						split -= dstShift * h;
						prevHour = (prevHour + incrHours) % 24;
						let prevSplit = splits[splits.length - 1];
						if (roundDec((split - prevSplit) / foundIncr, 3) * pctSpace >= .7) splits.push(split);
					} else splits.push(split);
				}
			}
			return splits;
		};
	}
	return [
		timeIncrs,
		_timeAxisStamps,
		timeAxisSplits
	];
}
var [timeIncrsMs, _timeAxisStampsMs, timeAxisSplitsMs] = genTimeStuffs(1);
var [timeIncrsS, _timeAxisStampsS, timeAxisSplitsS] = genTimeStuffs(.001);
genIncrs(2, -53, 53, [1]);
function timeAxisStamps(stampCfg, fmtDate) {
	return stampCfg.map((s) => s.map((v, i) => i == 0 || i == 8 || v == null ? v : fmtDate(i == 1 || s[8] == 0 ? v : s[1] + v)));
}
function timeAxisVals(tzDate, stamps) {
	return (self, splits, axisIdx, foundSpace, foundIncr) => {
		let s = stamps.find((s) => foundIncr >= s[0]) || stamps[stamps.length - 1];
		let prevYear;
		let prevMnth;
		let prevDate;
		let prevHour;
		let prevMins;
		let prevSecs;
		return splits.map((split) => {
			let date = tzDate(split);
			let newYear = date.getFullYear();
			let newMnth = date.getMonth();
			let newDate = date.getDate();
			let newHour = date.getHours();
			let newMins = date.getMinutes();
			let newSecs = date.getSeconds();
			let stamp = newYear != prevYear && s[2] || newMnth != prevMnth && s[3] || newDate != prevDate && s[4] || newHour != prevHour && s[5] || newMins != prevMins && s[6] || newSecs != prevSecs && s[7] || s[1];
			prevYear = newYear;
			prevMnth = newMnth;
			prevDate = newDate;
			prevHour = newHour;
			prevMins = newMins;
			prevSecs = newSecs;
			return stamp(date);
		});
	};
}
function timeAxisVal(tzDate, dateTpl) {
	let stamp = fmtDate(dateTpl);
	return (self, splits, axisIdx, foundSpace, foundIncr) => splits.map((split) => stamp(tzDate(split)));
}
function mkDate(y, m, d) {
	return new Date(y, m, d);
}
function timeSeriesStamp(stampCfg, fmtDate) {
	return fmtDate(stampCfg);
}
var _timeSeriesStamp = "{YYYY}-{MM}-{DD} {h}:{mm}{aa}";
function timeSeriesVal(tzDate, stamp) {
	return (self, val, seriesIdx, dataIdx) => dataIdx == null ? LEGEND_DISP : stamp(tzDate(val));
}
function legendStroke(self, seriesIdx) {
	let s = self.series[seriesIdx];
	return s.width ? s.stroke(self, seriesIdx) : s.points.width ? s.points.stroke(self, seriesIdx) : null;
}
function legendFill(self, seriesIdx) {
	return self.series[seriesIdx].fill(self, seriesIdx);
}
var legendOpts = {
	show: true,
	live: true,
	isolate: false,
	mount: noop,
	markers: {
		show: true,
		width: 2,
		stroke: legendStroke,
		fill: legendFill,
		dash: "solid"
	},
	idx: null,
	idxs: null,
	values: []
};
function cursorPointShow(self, si) {
	let o = self.cursor.points;
	let pt = placeDiv();
	let size = o.size(self, si);
	setStylePx(pt, WIDTH, size);
	setStylePx(pt, HEIGHT$2, size);
	let mar = size / -2;
	setStylePx(pt, "marginLeft", mar);
	setStylePx(pt, "marginTop", mar);
	let width = o.width(self, si, size);
	width && setStylePx(pt, "borderWidth", width);
	return pt;
}
function cursorPointFill(self, si) {
	let sp = self.series[si].points;
	return sp._fill || sp._stroke;
}
function cursorPointStroke(self, si) {
	let sp = self.series[si].points;
	return sp._stroke || sp._fill;
}
function cursorPointSize(self, si) {
	return self.series[si].points.size;
}
var moveTuple = [0, 0];
function cursorMove(self, mouseLeft1, mouseTop1) {
	moveTuple[0] = mouseLeft1;
	moveTuple[1] = mouseTop1;
	return moveTuple;
}
function filtBtn0(self, targ, handle, onlyTarg = true) {
	return (e) => {
		e.button == 0 && (!onlyTarg || e.target == targ) && handle(e);
	};
}
function filtTarg(self, targ, handle, onlyTarg = true) {
	return (e) => {
		(!onlyTarg || e.target == targ) && handle(e);
	};
}
var cursorOpts = {
	show: true,
	x: true,
	y: true,
	lock: false,
	move: cursorMove,
	points: {
		one: false,
		show: cursorPointShow,
		size: cursorPointSize,
		width: 0,
		stroke: cursorPointStroke,
		fill: cursorPointFill
	},
	bind: {
		mousedown: filtBtn0,
		mouseup: filtBtn0,
		click: filtBtn0,
		dblclick: filtBtn0,
		mousemove: filtTarg,
		mouseleave: filtTarg,
		mouseenter: filtTarg
	},
	drag: {
		setScale: true,
		x: true,
		y: false,
		dist: 0,
		uni: null,
		click: (self, e) => {
			e.stopPropagation();
			e.stopImmediatePropagation();
		},
		_x: false,
		_y: false
	},
	focus: {
		dist: (self, seriesIdx, dataIdx, valPos, curPos) => valPos - curPos,
		prox: -1,
		bias: 0
	},
	hover: {
		skip: [void 0],
		prox: null,
		bias: 0
	},
	left: -10,
	top: -10,
	idx: null,
	dataIdx: null,
	idxs: null,
	event: null
};
var axisLines = {
	show: true,
	stroke: "rgba(0,0,0,0.07)",
	width: 2
};
var grid = assign({}, axisLines, { filter: retArg1 });
var ticks = assign({}, grid, { size: 10 });
var border = assign({}, axisLines, { show: false });
var font$1 = "12px system-ui, -apple-system, \"Segoe UI\", Roboto, \"Helvetica Neue\", Arial, \"Noto Sans\", sans-serif, \"Apple Color Emoji\", \"Segoe UI Emoji\", \"Segoe UI Symbol\", \"Noto Color Emoji\"";
var labelFont = "bold " + font$1;
var lineGap = 1.5;
var xAxisOpts = {
	show: true,
	scale: "x",
	stroke: hexBlack,
	space: 50,
	gap: 5,
	alignTo: 1,
	size: 50,
	labelGap: 0,
	labelSize: 30,
	labelFont,
	side: 2,
	grid,
	ticks,
	border,
	font: font$1,
	lineGap,
	rotate: 0
};
var numSeriesLabel = "Value";
var timeSeriesLabel = "Time";
var xSeriesOpts = {
	show: true,
	scale: "x",
	auto: false,
	sorted: 1,
	min: inf,
	max: -Infinity,
	idxs: []
};
function numAxisVals(self, splits, axisIdx, foundSpace, foundIncr) {
	return splits.map((v) => v == null ? "" : fmtNum(v));
}
function numAxisSplits(self, axisIdx, scaleMin, scaleMax, foundIncr, foundSpace, forceMin) {
	let splits = [];
	let numDec = fixedDec.get(foundIncr) || 0;
	scaleMin = forceMin ? scaleMin : roundDec(incrRoundUp(scaleMin, foundIncr), numDec);
	for (let val = scaleMin; val <= scaleMax; val = roundDec(val + foundIncr, numDec)) splits.push(Object.is(val, -0) ? 0 : val);
	return splits;
}
function logAxisSplits(self, axisIdx, scaleMin, scaleMax, foundIncr, foundSpace, forceMin) {
	const splits = [];
	const logBase = self.scales[self.axes[axisIdx].scale].log;
	foundIncr = pow(logBase, floor((logBase == 10 ? log10 : log2)(scaleMin)));
	if (logBase == 10) foundIncr = numIncrs[closestIdx(foundIncr, numIncrs)];
	let split = scaleMin;
	let nextMagIncr = foundIncr * logBase;
	if (logBase == 10) nextMagIncr = numIncrs[closestIdx(nextMagIncr, numIncrs)];
	do {
		splits.push(split);
		split = split + foundIncr;
		if (logBase == 10 && !fixedDec.has(split)) split = roundDec(split, fixedDec.get(foundIncr));
		if (split >= nextMagIncr) {
			foundIncr = split;
			nextMagIncr = foundIncr * logBase;
			if (logBase == 10) nextMagIncr = numIncrs[closestIdx(nextMagIncr, numIncrs)];
		}
	} while (split <= scaleMax);
	return splits;
}
function asinhAxisSplits(self, axisIdx, scaleMin, scaleMax, foundIncr, foundSpace, forceMin) {
	let linthresh = self.scales[self.axes[axisIdx].scale].asinh;
	let posSplits = scaleMax > linthresh ? logAxisSplits(self, axisIdx, max(linthresh, scaleMin), scaleMax, foundIncr) : [linthresh];
	let zero = scaleMax >= 0 && scaleMin <= 0 ? [0] : [];
	return (scaleMin < -linthresh ? logAxisSplits(self, axisIdx, max(linthresh, -scaleMax), -scaleMin, foundIncr) : [linthresh]).reverse().map((v) => -v).concat(zero, posSplits);
}
var RE_ALL = /./;
var RE_12357 = /[12357]/;
var RE_125 = /[125]/;
var RE_1 = /1/;
var _filt = (splits, distr, re, keepMod) => splits.map((v, i) => distr == 4 && v == 0 || i % keepMod == 0 && re.test(v.toExponential()[v < 0 ? 1 : 0]) ? v : null);
function log10AxisValsFilt(self, splits, axisIdx, foundSpace, foundIncr) {
	let axis = self.axes[axisIdx];
	let scaleKey = axis.scale;
	let sc = self.scales[scaleKey];
	let valToPos = self.valToPos;
	let minSpace = axis._space;
	let _10 = valToPos(10, scaleKey);
	let re = valToPos(9, scaleKey) - _10 >= minSpace ? RE_ALL : valToPos(7, scaleKey) - _10 >= minSpace ? RE_12357 : valToPos(5, scaleKey) - _10 >= minSpace ? RE_125 : RE_1;
	if (re == RE_1) {
		let magSpace = abs(valToPos(1, scaleKey) - _10);
		if (magSpace < minSpace) return _filt(splits.slice().reverse(), sc.distr, re, ceil(minSpace / magSpace)).reverse();
	}
	return _filt(splits, sc.distr, re, 1);
}
function log2AxisValsFilt(self, splits, axisIdx, foundSpace, foundIncr) {
	let axis = self.axes[axisIdx];
	let scaleKey = axis.scale;
	let minSpace = axis._space;
	let valToPos = self.valToPos;
	let magSpace = abs(valToPos(1, scaleKey) - valToPos(2, scaleKey));
	if (magSpace < minSpace) return _filt(splits.slice().reverse(), 3, RE_ALL, ceil(minSpace / magSpace)).reverse();
	return splits;
}
function numSeriesVal(self, val, seriesIdx, dataIdx) {
	return dataIdx == null ? LEGEND_DISP : val == null ? "" : fmtNum(val);
}
var yAxisOpts = {
	show: true,
	scale: "y",
	stroke: hexBlack,
	space: 30,
	gap: 5,
	alignTo: 1,
	size: 50,
	labelGap: 0,
	labelSize: 30,
	labelFont,
	side: 3,
	grid,
	ticks,
	border,
	font: font$1,
	lineGap,
	rotate: 0
};
function ptDia(width, mult) {
	return roundDec((3 + (width || 1) * 2) * mult, 3);
}
function seriesPointsShow(self, si) {
	let { scale, idxs } = self.series[0];
	let xData = self._data[0];
	let p0 = self.valToPos(xData[idxs[0]], scale, true);
	let maxPts = abs(self.valToPos(xData[idxs[1]], scale, true) - p0) / (self.series[si].points.space * pxRatio);
	return idxs[1] - idxs[0] <= maxPts;
}
var facet = {
	scale: null,
	auto: true,
	sorted: 0,
	min: inf,
	max: -Infinity
};
var gaps = (self, seriesIdx, idx0, idx1, nullGaps) => nullGaps;
var xySeriesOpts = {
	show: true,
	auto: true,
	sorted: 0,
	gaps,
	alpha: 1,
	facets: [assign({}, facet, { scale: "x" }), assign({}, facet, { scale: "y" })]
};
var ySeriesOpts = {
	scale: "y",
	auto: true,
	sorted: 0,
	show: true,
	spanGaps: false,
	gaps,
	alpha: 1,
	points: {
		show: seriesPointsShow,
		filter: null
	},
	values: null,
	min: inf,
	max: -Infinity,
	idxs: [],
	path: null,
	clip: null
};
function clampScale(self, val, scaleMin, scaleMax, scaleKey) {
	return scaleMin / 10;
}
var xScaleOpts = {
	time: FEAT_TIME,
	auto: true,
	distr: 1,
	log: 10,
	asinh: 1,
	min: null,
	max: null,
	dir: 1,
	ori: 0
};
var yScaleOpts = assign({}, xScaleOpts, {
	time: false,
	ori: 1
});
var syncs = {};
function _sync(key, opts) {
	let s = syncs[key];
	if (!s) {
		s = {
			key,
			plots: [],
			sub(plot) {
				s.plots.push(plot);
			},
			unsub(plot) {
				s.plots = s.plots.filter((c) => c != plot);
			},
			pub(type, self, x, y, w, h, i) {
				for (let j = 0; j < s.plots.length; j++) s.plots[j] != self && s.plots[j].pub(type, self, x, y, w, h, i);
			}
		};
		if (key != null) syncs[key] = s;
	}
	return s;
}
var BAND_CLIP_FILL = 1;
var BAND_CLIP_STROKE = 2;
function orient(u, seriesIdx, cb) {
	const mode = u.mode;
	const series = u.series[seriesIdx];
	const data = mode == 2 ? u._data[seriesIdx] : u._data;
	const scales = u.scales;
	const bbox = u.bbox;
	let dx = data[0], dy = mode == 2 ? data[1] : data[seriesIdx], sx = mode == 2 ? scales[series.facets[0].scale] : scales[u.series[0].scale], sy = mode == 2 ? scales[series.facets[1].scale] : scales[series.scale], l = bbox.left, t = bbox.top, w = bbox.width, h = bbox.height, H = u.valToPosH, V = u.valToPosV;
	return sx.ori == 0 ? cb(series, dx, dy, sx, sy, H, V, l, t, w, h, moveToH, lineToH, rectH, arcH, bezierCurveToH) : cb(series, dx, dy, sx, sy, V, H, t, l, h, w, moveToV, lineToV, rectV, arcV, bezierCurveToV);
}
function bandFillClipDirs(self, seriesIdx) {
	let fillDir = 0;
	let clipDirs = 0;
	let bands = ifNull(self.bands, EMPTY_ARR);
	for (let i = 0; i < bands.length; i++) {
		let b = bands[i];
		if (b.series[0] == seriesIdx) fillDir = b.dir;
		else if (b.series[1] == seriesIdx) {
			if (b.dir == 1) clipDirs |= 1;
			else clipDirs |= 2;
		}
	}
	return [fillDir, clipDirs == 1 ? -1 : clipDirs == 2 ? 1 : clipDirs == 3 ? 2 : 0];
}
function seriesFillTo(self, seriesIdx, dataMin, dataMax, bandFillDir) {
	let mode = self.mode;
	let series = self.series[seriesIdx];
	let scaleKey = mode == 2 ? series.facets[1].scale : series.scale;
	let scale = self.scales[scaleKey];
	return bandFillDir == -1 ? scale.min : bandFillDir == 1 ? scale.max : scale.distr == 3 ? scale.dir == 1 ? scale.min : scale.max : 0;
}
function clipBandLine(self, seriesIdx, idx0, idx1, strokePath, clipDir) {
	return orient(self, seriesIdx, (series, dataX, dataY, scaleX, scaleY, valToPosX, valToPosY, xOff, yOff, xDim, yDim) => {
		let pxRound = series.pxRound;
		const dir = scaleX.dir * (scaleX.ori == 0 ? 1 : -1);
		const lineTo = scaleX.ori == 0 ? lineToH : lineToV;
		let frIdx, toIdx;
		if (dir == 1) {
			frIdx = idx0;
			toIdx = idx1;
		} else {
			frIdx = idx1;
			toIdx = idx0;
		}
		let x0 = pxRound(valToPosX(dataX[frIdx], scaleX, xDim, xOff));
		let y0 = pxRound(valToPosY(dataY[frIdx], scaleY, yDim, yOff));
		let x1 = pxRound(valToPosX(dataX[toIdx], scaleX, xDim, xOff));
		let yLimit = pxRound(valToPosY(clipDir == 1 ? scaleY.max : scaleY.min, scaleY, yDim, yOff));
		let clip = new Path2D(strokePath);
		lineTo(clip, x1, yLimit);
		lineTo(clip, x0, yLimit);
		lineTo(clip, x0, y0);
		return clip;
	});
}
function clipGaps(gaps, ori, plotLft, plotTop, plotWid, plotHgt) {
	let clip = null;
	if (gaps.length > 0) {
		clip = new Path2D();
		const rect = ori == 0 ? rectH : rectV;
		let prevGapEnd = plotLft;
		for (let i = 0; i < gaps.length; i++) {
			let g = gaps[i];
			if (g[1] > g[0]) {
				let w = g[0] - prevGapEnd;
				w > 0 && rect(clip, prevGapEnd, plotTop, w, plotTop + plotHgt);
				prevGapEnd = g[1];
			}
		}
		let w = plotLft + plotWid - prevGapEnd;
		let maxStrokeWidth = 10;
		w > 0 && rect(clip, prevGapEnd, plotTop - maxStrokeWidth / 2, w, plotTop + plotHgt + maxStrokeWidth);
	}
	return clip;
}
function addGap(gaps, fromX, toX) {
	let prevGap = gaps[gaps.length - 1];
	if (prevGap && prevGap[0] == fromX) prevGap[1] = toX;
	else gaps.push([fromX, toX]);
}
function findGaps(xs, ys, idx0, idx1, dir, pixelForX, align) {
	let gaps = [];
	let len = xs.length;
	for (let i = dir == 1 ? idx0 : idx1; i >= idx0 && i <= idx1; i += dir) if (ys[i] === null) {
		let fr = i, to = i;
		if (dir == 1) while (++i <= idx1 && ys[i] === null) to = i;
		else while (--i >= idx0 && ys[i] === null) to = i;
		let frPx = pixelForX(xs[fr]);
		let toPx = to == fr ? frPx : pixelForX(xs[to]);
		let fri2 = fr - dir;
		frPx = align <= 0 && fri2 >= 0 && fri2 < len ? pixelForX(xs[fri2]) : frPx;
		let toi2 = to + dir;
		toPx = align >= 0 && toi2 >= 0 && toi2 < len ? pixelForX(xs[toi2]) : toPx;
		if (toPx >= frPx) gaps.push([frPx, toPx]);
	}
	return gaps;
}
function pxRoundGen(pxAlign) {
	return pxAlign == 0 ? retArg0 : pxAlign == 1 ? round$1 : (v) => incrRound(v, pxAlign);
}
function rect(ori) {
	let moveTo = ori == 0 ? moveToH : moveToV;
	let arcTo = ori == 0 ? (p, x1, y1, x2, y2, r) => {
		p.arcTo(x1, y1, x2, y2, r);
	} : (p, y1, x1, y2, x2, r) => {
		p.arcTo(x1, y1, x2, y2, r);
	};
	let rect = ori == 0 ? (p, x, y, w, h) => {
		p.rect(x, y, w, h);
	} : (p, y, x, h, w) => {
		p.rect(x, y, w, h);
	};
	return (p, x, y, w, h, endRad = 0, baseRad = 0) => {
		if (endRad == 0 && baseRad == 0) rect(p, x, y, w, h);
		else {
			endRad = min(endRad, w / 2, h / 2);
			baseRad = min(baseRad, w / 2, h / 2);
			moveTo(p, x + endRad, y);
			arcTo(p, x + w, y, x + w, y + h, endRad);
			arcTo(p, x + w, y + h, x, y + h, baseRad);
			arcTo(p, x, y + h, x, y, baseRad);
			arcTo(p, x, y, x + w, y, endRad);
			p.closePath();
		}
	};
}
var moveToH = (p, x, y) => {
	p.moveTo(x, y);
};
var moveToV = (p, y, x) => {
	p.moveTo(x, y);
};
var lineToH = (p, x, y) => {
	p.lineTo(x, y);
};
var lineToV = (p, y, x) => {
	p.lineTo(x, y);
};
var rectH = rect(0);
var rectV = rect(1);
var arcH = (p, x, y, r, startAngle, endAngle) => {
	p.arc(x, y, r, startAngle, endAngle);
};
var arcV = (p, y, x, r, startAngle, endAngle) => {
	p.arc(x, y, r, startAngle, endAngle);
};
var bezierCurveToH = (p, bp1x, bp1y, bp2x, bp2y, p2x, p2y) => {
	p.bezierCurveTo(bp1x, bp1y, bp2x, bp2y, p2x, p2y);
};
var bezierCurveToV = (p, bp1y, bp1x, bp2y, bp2x, p2y, p2x) => {
	p.bezierCurveTo(bp1x, bp1y, bp2x, bp2y, p2x, p2y);
};
function points(opts) {
	return (u, seriesIdx, idx0, idx1, filtIdxs) => {
		return orient(u, seriesIdx, (series, dataX, dataY, scaleX, scaleY, valToPosX, valToPosY, xOff, yOff, xDim, yDim) => {
			let { pxRound, points } = series;
			let moveTo, arc;
			if (scaleX.ori == 0) {
				moveTo = moveToH;
				arc = arcH;
			} else {
				moveTo = moveToV;
				arc = arcV;
			}
			const width = roundDec(points.width * pxRatio, 3);
			let rad = (points.size - points.width) / 2 * pxRatio;
			let dia = roundDec(rad * 2, 3);
			let fill = new Path2D();
			let clip = new Path2D();
			let { left: lft, top, width: wid, height: hgt } = u.bbox;
			rectH(clip, lft - dia, top - dia, wid + dia * 2, hgt + dia * 2);
			const drawPoint = (pi) => {
				if (dataY[pi] != null) {
					let x = pxRound(valToPosX(dataX[pi], scaleX, xDim, xOff));
					let y = pxRound(valToPosY(dataY[pi], scaleY, yDim, yOff));
					moveTo(fill, x + rad, y);
					arc(fill, x, y, rad, 0, PI * 2);
				}
			};
			if (filtIdxs) filtIdxs.forEach(drawPoint);
			else for (let pi = idx0; pi <= idx1; pi++) drawPoint(pi);
			return {
				stroke: width > 0 ? fill : null,
				fill,
				clip,
				flags: 3
			};
		});
	};
}
function _drawAcc(lineTo) {
	return (stroke, accX, minY, maxY, inY, outY) => {
		if (minY != maxY) {
			if (inY != minY && outY != minY) lineTo(stroke, accX, minY);
			if (inY != maxY && outY != maxY) lineTo(stroke, accX, maxY);
			lineTo(stroke, accX, outY);
		}
	};
}
var drawAccH = _drawAcc(lineToH);
var drawAccV = _drawAcc(lineToV);
function linear(opts) {
	const alignGaps = ifNull(opts?.alignGaps, 0);
	return (u, seriesIdx, idx0, idx1) => {
		return orient(u, seriesIdx, (series, dataX, dataY, scaleX, scaleY, valToPosX, valToPosY, xOff, yOff, xDim, yDim) => {
			[idx0, idx1] = nonNullIdxs(dataY, idx0, idx1);
			let pxRound = series.pxRound;
			let pixelForX = (val) => pxRound(valToPosX(val, scaleX, xDim, xOff));
			let pixelForY = (val) => pxRound(valToPosY(val, scaleY, yDim, yOff));
			let lineTo, drawAcc;
			if (scaleX.ori == 0) {
				lineTo = lineToH;
				drawAcc = drawAccH;
			} else {
				lineTo = lineToV;
				drawAcc = drawAccV;
			}
			const dir = scaleX.dir * (scaleX.ori == 0 ? 1 : -1);
			const _paths = {
				stroke: new Path2D(),
				fill: null,
				clip: null,
				band: null,
				gaps: null,
				flags: BAND_CLIP_FILL
			};
			const stroke = _paths.stroke;
			let hasGap = false;
			if (idx1 - idx0 >= xDim * 4) {
				let xForPixel = (pos) => u.posToVal(pos, scaleX.key, true);
				let minY = null, maxY = null, inY, outY, drawnAtX;
				let accX = pixelForX(dataX[dir == 1 ? idx0 : idx1]);
				let idx0px = pixelForX(dataX[idx0]);
				let idx1px = pixelForX(dataX[idx1]);
				let nextAccXVal = xForPixel(dir == 1 ? idx0px + 1 : idx1px - 1);
				for (let i = dir == 1 ? idx0 : idx1; i >= idx0 && i <= idx1; i += dir) {
					let xVal = dataX[i];
					let x = (dir == 1 ? xVal < nextAccXVal : xVal > nextAccXVal) ? accX : pixelForX(xVal);
					let yVal = dataY[i];
					if (x == accX) {
						if (yVal != null) {
							outY = yVal;
							if (minY == null) {
								lineTo(stroke, x, pixelForY(outY));
								inY = minY = maxY = outY;
							} else if (outY < minY) minY = outY;
							else if (outY > maxY) maxY = outY;
						} else if (yVal === null) hasGap = true;
					} else {
						if (minY != null) drawAcc(stroke, accX, pixelForY(minY), pixelForY(maxY), pixelForY(inY), pixelForY(outY));
						if (yVal != null) {
							outY = yVal;
							lineTo(stroke, x, pixelForY(outY));
							minY = maxY = inY = outY;
						} else {
							minY = maxY = null;
							if (yVal === null) hasGap = true;
						}
						accX = x;
						nextAccXVal = xForPixel(accX + dir);
					}
				}
				if (minY != null && minY != maxY && drawnAtX != accX) drawAcc(stroke, accX, pixelForY(minY), pixelForY(maxY), pixelForY(inY), pixelForY(outY));
			} else for (let i = dir == 1 ? idx0 : idx1; i >= idx0 && i <= idx1; i += dir) {
				let yVal = dataY[i];
				if (yVal === null) hasGap = true;
				else if (yVal != null) lineTo(stroke, pixelForX(dataX[i]), pixelForY(yVal));
			}
			let [bandFillDir, bandClipDir] = bandFillClipDirs(u, seriesIdx);
			if (series.fill != null || bandFillDir != 0) {
				let fill = _paths.fill = new Path2D(stroke);
				let fillToY = pixelForY(series.fillTo(u, seriesIdx, series.min, series.max, bandFillDir));
				let frX = pixelForX(dataX[idx0]);
				let toX = pixelForX(dataX[idx1]);
				if (dir == -1) [toX, frX] = [frX, toX];
				lineTo(fill, toX, fillToY);
				lineTo(fill, frX, fillToY);
			}
			if (!series.spanGaps) {
				let gaps = [];
				hasGap && gaps.push(...findGaps(dataX, dataY, idx0, idx1, dir, pixelForX, alignGaps));
				_paths.gaps = gaps = series.gaps(u, seriesIdx, idx0, idx1, gaps);
				_paths.clip = clipGaps(gaps, scaleX.ori, xOff, yOff, xDim, yDim);
			}
			if (bandClipDir != 0) _paths.band = bandClipDir == 2 ? [clipBandLine(u, seriesIdx, idx0, idx1, stroke, -1), clipBandLine(u, seriesIdx, idx0, idx1, stroke, 1)] : clipBandLine(u, seriesIdx, idx0, idx1, stroke, bandClipDir);
			return _paths;
		});
	};
}
function stepped$1(opts) {
	const align = ifNull(opts.align, 1);
	const ascDesc = ifNull(opts.ascDesc, false);
	const alignGaps = ifNull(opts.alignGaps, 0);
	const extend = ifNull(opts.extend, false);
	return (u, seriesIdx, idx0, idx1) => {
		return orient(u, seriesIdx, (series, dataX, dataY, scaleX, scaleY, valToPosX, valToPosY, xOff, yOff, xDim, yDim) => {
			[idx0, idx1] = nonNullIdxs(dataY, idx0, idx1);
			let pxRound = series.pxRound;
			let { left, width } = u.bbox;
			let pixelForX = (val) => pxRound(valToPosX(val, scaleX, xDim, xOff));
			let pixelForY = (val) => pxRound(valToPosY(val, scaleY, yDim, yOff));
			let lineTo = scaleX.ori == 0 ? lineToH : lineToV;
			const _paths = {
				stroke: new Path2D(),
				fill: null,
				clip: null,
				band: null,
				gaps: null,
				flags: BAND_CLIP_FILL
			};
			const stroke = _paths.stroke;
			const dir = scaleX.dir * (scaleX.ori == 0 ? 1 : -1);
			let prevYPos = pixelForY(dataY[dir == 1 ? idx0 : idx1]);
			let firstXPos = pixelForX(dataX[dir == 1 ? idx0 : idx1]);
			let prevXPos = firstXPos;
			let firstXPosExt = firstXPos;
			if (extend && align == -1) {
				firstXPosExt = left;
				lineTo(stroke, firstXPosExt, prevYPos);
			}
			lineTo(stroke, firstXPos, prevYPos);
			for (let i = dir == 1 ? idx0 : idx1; i >= idx0 && i <= idx1; i += dir) {
				let yVal1 = dataY[i];
				if (yVal1 == null) continue;
				let x1 = pixelForX(dataX[i]);
				let y1 = pixelForY(yVal1);
				if (align == 1) lineTo(stroke, x1, prevYPos);
				else lineTo(stroke, prevXPos, y1);
				lineTo(stroke, x1, y1);
				prevYPos = y1;
				prevXPos = x1;
			}
			let prevXPosExt = prevXPos;
			if (extend && align == 1) {
				prevXPosExt = left + width;
				lineTo(stroke, prevXPosExt, prevYPos);
			}
			let [bandFillDir, bandClipDir] = bandFillClipDirs(u, seriesIdx);
			if (series.fill != null || bandFillDir != 0) {
				let fill = _paths.fill = new Path2D(stroke);
				let fillToY = pixelForY(series.fillTo(u, seriesIdx, series.min, series.max, bandFillDir));
				lineTo(fill, prevXPosExt, fillToY);
				lineTo(fill, firstXPosExt, fillToY);
			}
			if (!series.spanGaps) {
				let gaps = [];
				gaps.push(...findGaps(dataX, dataY, idx0, idx1, dir, pixelForX, alignGaps));
				let halfStroke = series.width * pxRatio / 2;
				let startsOffset = ascDesc || align == 1 ? halfStroke : -halfStroke;
				let endsOffset = ascDesc || align == -1 ? -halfStroke : halfStroke;
				gaps.forEach((g) => {
					g[0] += startsOffset;
					g[1] += endsOffset;
				});
				_paths.gaps = gaps = series.gaps(u, seriesIdx, idx0, idx1, gaps);
				_paths.clip = clipGaps(gaps, scaleX.ori, xOff, yOff, xDim, yDim);
			}
			if (bandClipDir != 0) _paths.band = bandClipDir == 2 ? [clipBandLine(u, seriesIdx, idx0, idx1, stroke, -1), clipBandLine(u, seriesIdx, idx0, idx1, stroke, 1)] : clipBandLine(u, seriesIdx, idx0, idx1, stroke, bandClipDir);
			return _paths;
		});
	};
}
function findColWidth(dataX, dataY, valToPosX, scaleX, xDim, xOff, colWid = inf) {
	if (dataX.length > 1) {
		let prevIdx = null;
		for (let i = 0, minDelta = Infinity; i < dataX.length; i++) if (dataY[i] !== void 0) {
			if (prevIdx != null) {
				let delta = abs(dataX[i] - dataX[prevIdx]);
				if (delta < minDelta) {
					minDelta = delta;
					colWid = abs(valToPosX(dataX[i], scaleX, xDim, xOff) - valToPosX(dataX[prevIdx], scaleX, xDim, xOff));
				}
			}
			prevIdx = i;
		}
	}
	return colWid;
}
function bars(opts) {
	opts = opts || EMPTY_OBJ;
	const size = ifNull(opts.size, [
		.6,
		inf,
		1
	]);
	const align = opts.align || 0;
	const _extraGap = opts.gap || 0;
	let ro = opts.radius;
	ro = ro == null ? [0, 0] : typeof ro == "number" ? [ro, 0] : ro;
	const radiusFn = fnOrSelf(ro);
	const gapFactor = 1 - size[0];
	const _maxWidth = ifNull(size[1], inf);
	const _minWidth = ifNull(size[2], 1);
	const disp = ifNull(opts.disp, EMPTY_OBJ);
	const _each = ifNull(opts.each, (_) => {});
	const { fill: dispFills, stroke: dispStrokes } = disp;
	return (u, seriesIdx, idx0, idx1) => {
		return orient(u, seriesIdx, (series, dataX, dataY, scaleX, scaleY, valToPosX, valToPosY, xOff, yOff, xDim, yDim) => {
			let pxRound = series.pxRound;
			let _align = align;
			let extraGap = _extraGap * pxRatio;
			let maxWidth = _maxWidth * pxRatio;
			let minWidth = _minWidth * pxRatio;
			let valRadius, baseRadius;
			if (scaleX.ori == 0) [valRadius, baseRadius] = radiusFn(u, seriesIdx);
			else [baseRadius, valRadius] = radiusFn(u, seriesIdx);
			const _dirX = scaleX.dir * (scaleX.ori == 0 ? 1 : -1);
			let rect = scaleX.ori == 0 ? rectH : rectV;
			let each = scaleX.ori == 0 ? _each : (u, seriesIdx, i, top, lft, hgt, wid) => {
				_each(u, seriesIdx, i, lft, top, wid, hgt);
			};
			let band = ifNull(u.bands, EMPTY_ARR).find((b) => b.series[0] == seriesIdx);
			let fillDir = band != null ? band.dir : 0;
			let fillTo = series.fillTo(u, seriesIdx, series.min, series.max, fillDir);
			let fillToY = pxRound(valToPosY(fillTo, scaleY, yDim, yOff));
			let xShift, barWid, fullGap, colWid = xDim;
			let strokeWidth = pxRound(series.width * pxRatio);
			let multiPath = false;
			let fillColors = null;
			let fillPaths = null;
			let strokeColors = null;
			let strokePaths = null;
			if (dispFills != null && (strokeWidth == 0 || dispStrokes != null)) {
				multiPath = true;
				fillColors = dispFills.values(u, seriesIdx, idx0, idx1);
				fillPaths = /* @__PURE__ */ new Map();
				new Set(fillColors).forEach((color) => {
					if (color != null) fillPaths.set(color, new Path2D());
				});
				if (strokeWidth > 0) {
					strokeColors = dispStrokes.values(u, seriesIdx, idx0, idx1);
					strokePaths = /* @__PURE__ */ new Map();
					new Set(strokeColors).forEach((color) => {
						if (color != null) strokePaths.set(color, new Path2D());
					});
				}
			}
			let { x0, size } = disp;
			if (x0 != null && size != null) {
				_align = 1;
				dataX = x0.values(u, seriesIdx, idx0, idx1);
				if (x0.unit == 2) dataX = dataX.map((pct) => u.posToVal(xOff + pct * xDim, scaleX.key, true));
				let sizes = size.values(u, seriesIdx, idx0, idx1);
				if (size.unit == 2) barWid = sizes[0] * xDim;
				else barWid = valToPosX(sizes[0], scaleX, xDim, xOff) - valToPosX(0, scaleX, xDim, xOff);
				colWid = findColWidth(dataX, dataY, valToPosX, scaleX, xDim, xOff, colWid);
				fullGap = colWid - barWid + extraGap;
			} else {
				colWid = findColWidth(dataX, dataY, valToPosX, scaleX, xDim, xOff, colWid);
				fullGap = colWid * gapFactor + extraGap;
				barWid = colWid - fullGap;
			}
			if (fullGap < 1) fullGap = 0;
			if (strokeWidth >= barWid / 2) strokeWidth = 0;
			if (fullGap < 5) pxRound = retArg0;
			let insetStroke = fullGap > 0;
			let rawBarWid = colWid - fullGap - (insetStroke ? strokeWidth : 0);
			barWid = pxRound(clamp(rawBarWid, minWidth, maxWidth));
			xShift = (_align == 0 ? barWid / 2 : _align == _dirX ? 0 : barWid) - _align * _dirX * ((_align == 0 ? extraGap / 2 : 0) + (insetStroke ? strokeWidth / 2 : 0));
			const _paths = {
				stroke: null,
				fill: null,
				clip: null,
				band: null,
				gaps: null,
				flags: 0
			};
			const stroke = multiPath ? null : new Path2D();
			let dataY0 = null;
			if (band != null) dataY0 = u.data[band.series[1]];
			else {
				let { y0, y1 } = disp;
				if (y0 != null && y1 != null) {
					dataY = y1.values(u, seriesIdx, idx0, idx1);
					dataY0 = y0.values(u, seriesIdx, idx0, idx1);
				}
			}
			let radVal = valRadius * barWid;
			let radBase = baseRadius * barWid;
			for (let i = _dirX == 1 ? idx0 : idx1; i >= idx0 && i <= idx1; i += _dirX) {
				let yVal = dataY[i];
				if (yVal == null) continue;
				if (dataY0 != null) {
					let yVal0 = dataY0[i] ?? 0;
					if (yVal - yVal0 == 0) continue;
					fillToY = valToPosY(yVal0, scaleY, yDim, yOff);
				}
				let xPos = valToPosX(scaleX.distr != 2 || disp != null ? dataX[i] : i, scaleX, xDim, xOff);
				let yPos = valToPosY(ifNull(yVal, fillTo), scaleY, yDim, yOff);
				let lft = pxRound(xPos - xShift);
				let btm = pxRound(max(yPos, fillToY));
				let top = pxRound(min(yPos, fillToY));
				let barHgt = btm - top;
				if (yVal != null) {
					let rv = yVal < 0 ? radBase : radVal;
					let rb = yVal < 0 ? radVal : radBase;
					if (multiPath) {
						if (strokeWidth > 0 && strokeColors[i] != null) rect(strokePaths.get(strokeColors[i]), lft, top + floor(strokeWidth / 2), barWid, max(0, barHgt - strokeWidth), rv, rb);
						if (fillColors[i] != null) rect(fillPaths.get(fillColors[i]), lft, top + floor(strokeWidth / 2), barWid, max(0, barHgt - strokeWidth), rv, rb);
					} else rect(stroke, lft, top + floor(strokeWidth / 2), barWid, max(0, barHgt - strokeWidth), rv, rb);
					each(u, seriesIdx, i, lft - strokeWidth / 2, top, barWid + strokeWidth, barHgt);
				}
			}
			if (strokeWidth > 0) _paths.stroke = multiPath ? strokePaths : stroke;
			else if (!multiPath) {
				_paths._fill = series.width == 0 ? series._fill : series._stroke ?? series._fill;
				_paths.width = 0;
			}
			_paths.fill = multiPath ? fillPaths : stroke;
			return _paths;
		});
	};
}
function splineInterp(interp, opts) {
	const alignGaps = ifNull(opts?.alignGaps, 0);
	return (u, seriesIdx, idx0, idx1) => {
		return orient(u, seriesIdx, (series, dataX, dataY, scaleX, scaleY, valToPosX, valToPosY, xOff, yOff, xDim, yDim) => {
			[idx0, idx1] = nonNullIdxs(dataY, idx0, idx1);
			let pxRound = series.pxRound;
			let pixelForX = (val) => pxRound(valToPosX(val, scaleX, xDim, xOff));
			let pixelForY = (val) => pxRound(valToPosY(val, scaleY, yDim, yOff));
			let moveTo, bezierCurveTo, lineTo;
			if (scaleX.ori == 0) {
				moveTo = moveToH;
				lineTo = lineToH;
				bezierCurveTo = bezierCurveToH;
			} else {
				moveTo = moveToV;
				lineTo = lineToV;
				bezierCurveTo = bezierCurveToV;
			}
			const dir = scaleX.dir * (scaleX.ori == 0 ? 1 : -1);
			let firstXPos = pixelForX(dataX[dir == 1 ? idx0 : idx1]);
			let prevXPos = firstXPos;
			let xCoords = [];
			let yCoords = [];
			for (let i = dir == 1 ? idx0 : idx1; i >= idx0 && i <= idx1; i += dir) if (dataY[i] != null) {
				let xVal = dataX[i];
				let xPos = pixelForX(xVal);
				xCoords.push(prevXPos = xPos);
				yCoords.push(pixelForY(dataY[i]));
			}
			const _paths = {
				stroke: interp(xCoords, yCoords, moveTo, lineTo, bezierCurveTo, pxRound),
				fill: null,
				clip: null,
				band: null,
				gaps: null,
				flags: BAND_CLIP_FILL
			};
			const stroke = _paths.stroke;
			let [bandFillDir, bandClipDir] = bandFillClipDirs(u, seriesIdx);
			if (series.fill != null || bandFillDir != 0) {
				let fill = _paths.fill = new Path2D(stroke);
				let fillToY = pixelForY(series.fillTo(u, seriesIdx, series.min, series.max, bandFillDir));
				lineTo(fill, prevXPos, fillToY);
				lineTo(fill, firstXPos, fillToY);
			}
			if (!series.spanGaps) {
				let gaps = [];
				gaps.push(...findGaps(dataX, dataY, idx0, idx1, dir, pixelForX, alignGaps));
				_paths.gaps = gaps = series.gaps(u, seriesIdx, idx0, idx1, gaps);
				_paths.clip = clipGaps(gaps, scaleX.ori, xOff, yOff, xDim, yDim);
			}
			if (bandClipDir != 0) _paths.band = bandClipDir == 2 ? [clipBandLine(u, seriesIdx, idx0, idx1, stroke, -1), clipBandLine(u, seriesIdx, idx0, idx1, stroke, 1)] : clipBandLine(u, seriesIdx, idx0, idx1, stroke, bandClipDir);
			return _paths;
		});
	};
}
function monotoneCubic(opts) {
	return splineInterp(_monotoneCubic, opts);
}
function _monotoneCubic(xs, ys, moveTo, lineTo, bezierCurveTo, pxRound) {
	const n = xs.length;
	if (n < 2) return null;
	const path = new Path2D();
	moveTo(path, xs[0], ys[0]);
	if (n == 2) lineTo(path, xs[1], ys[1]);
	else {
		let ms = Array(n), ds = Array(n - 1), dys = Array(n - 1), dxs = Array(n - 1);
		for (let i = 0; i < n - 1; i++) {
			dys[i] = ys[i + 1] - ys[i];
			dxs[i] = xs[i + 1] - xs[i];
			ds[i] = dys[i] / dxs[i];
		}
		ms[0] = ds[0];
		for (let i = 1; i < n - 1; i++) if (ds[i] === 0 || ds[i - 1] === 0 || ds[i - 1] > 0 !== ds[i] > 0) ms[i] = 0;
		else {
			ms[i] = 3 * (dxs[i - 1] + dxs[i]) / ((2 * dxs[i] + dxs[i - 1]) / ds[i - 1] + (dxs[i] + 2 * dxs[i - 1]) / ds[i]);
			if (!isFinite(ms[i])) ms[i] = 0;
		}
		ms[n - 1] = ds[n - 2];
		for (let i = 0; i < n - 1; i++) bezierCurveTo(path, xs[i] + dxs[i] / 3, ys[i] + ms[i] * dxs[i] / 3, xs[i + 1] - dxs[i] / 3, ys[i + 1] - ms[i + 1] * dxs[i] / 3, xs[i + 1], ys[i + 1]);
	}
	return path;
}
var cursorPlots = /* @__PURE__ */ new Set();
function invalidateRects() {
	for (let u of cursorPlots) u.syncRect(true);
}
if (domEnv) {
	on(resize, win, invalidateRects);
	on(scroll, win, invalidateRects, true);
	on(dppxchange, win, () => {
		uPlot.pxRatio = pxRatio;
	});
}
var linearPath = linear();
var pointsPath = points();
function setDefaults(d, xo, yo, initY) {
	return (initY ? [d[0], d[1]].concat(d.slice(2)) : [d[0]].concat(d.slice(1))).map((o, i) => setDefault(o, i, xo, yo));
}
function setDefaults2(d, xyo) {
	return d.map((o, i) => i == 0 ? {} : assign({}, xyo, o));
}
function setDefault(o, i, xo, yo) {
	return assign({}, i == 0 ? xo : yo, o);
}
function snapNumX(self, dataMin, dataMax) {
	return dataMin == null ? nullNullTuple : [dataMin, dataMax];
}
var snapTimeX = snapNumX;
function snapNumY(self, dataMin, dataMax) {
	return dataMin == null ? nullNullTuple : rangeNum(dataMin, dataMax, rangePad, true);
}
function snapLogY(self, dataMin, dataMax, scale) {
	return dataMin == null ? nullNullTuple : rangeLog(dataMin, dataMax, self.scales[scale].log, false);
}
var snapLogX = snapLogY;
function snapAsinhY(self, dataMin, dataMax, scale) {
	return dataMin == null ? nullNullTuple : rangeAsinh(dataMin, dataMax, self.scales[scale].log, false);
}
var snapAsinhX = snapAsinhY;
function findIncr(minVal, maxVal, incrs, dim, minSpace) {
	let intDigits = max(numIntDigits(minVal), numIntDigits(maxVal));
	let delta = maxVal - minVal;
	let incrIdx = closestIdx(minSpace / dim * delta, incrs);
	do {
		let foundIncr = incrs[incrIdx];
		let foundSpace = dim * foundIncr / delta;
		if (foundSpace >= minSpace && intDigits + (foundIncr < 5 ? fixedDec.get(foundIncr) : 0) <= 17) return [foundIncr, foundSpace];
	} while (++incrIdx < incrs.length);
	return [0, 0];
}
function pxRatioFont(font) {
	let fontSize, fontSizeCss;
	font = font.replace(/(\d+)px/, (m, p1) => (fontSize = round$1((fontSizeCss = +p1) * pxRatio)) + "px");
	return [
		font,
		fontSize,
		fontSizeCss
	];
}
function syncFontSize(axis) {
	if (axis.show) [axis.font, axis.labelFont].forEach((f) => {
		let size = roundDec(f[2] * pxRatio, 1);
		f[0] = f[0].replace(/[0-9.]+px/, size + "px");
		f[1] = size;
	});
}
function uPlot(opts, data, then) {
	const self = { mode: ifNull(opts.mode, 1) };
	const mode = self.mode;
	function getHPos(val, scale, dim, off) {
		let pct = scale.valToPct(val);
		return off + dim * (scale.dir == -1 ? 1 - pct : pct);
	}
	function getVPos(val, scale, dim, off) {
		let pct = scale.valToPct(val);
		return off + dim * (scale.dir == -1 ? pct : 1 - pct);
	}
	function getPos(val, scale, dim, off) {
		return scale.ori == 0 ? getHPos(val, scale, dim, off) : getVPos(val, scale, dim, off);
	}
	self.valToPosH = getHPos;
	self.valToPosV = getVPos;
	let ready = false;
	self.status = 0;
	const root = self.root = placeDiv(UPLOT);
	if (opts.id != null) root.id = opts.id;
	addClass(root, opts.class);
	if (opts.title) {
		let title = placeDiv(TITLE, root);
		title.textContent = opts.title;
	}
	const can = placeTag("canvas");
	const ctx = self.ctx = can.getContext("2d");
	const wrap = placeDiv(WRAP, root);
	on("click", wrap, (e) => {
		if (e.target === over) (mouseLeft1 != mouseLeft0 || mouseTop1 != mouseTop0) && drag.click(self, e);
	}, true);
	const under = self.under = placeDiv(UNDER, wrap);
	wrap.appendChild(can);
	const over = self.over = placeDiv(OVER$1, wrap);
	opts = copy(opts);
	const pxAlign = +ifNull(opts.pxAlign, 1);
	const pxRound = pxRoundGen(pxAlign);
	(opts.plugins || []).forEach((p) => {
		if (p.opts) opts = p.opts(self, opts) || opts;
	});
	const ms = opts.ms || .001;
	const series = self.series = mode == 1 ? setDefaults(opts.series || [], xSeriesOpts, ySeriesOpts, false) : setDefaults2(opts.series || [null], xySeriesOpts);
	const axes = self.axes = setDefaults(opts.axes || [], xAxisOpts, yAxisOpts, true);
	const scales = self.scales = {};
	const bands = self.bands = opts.bands || [];
	bands.forEach((b) => {
		b.fill = fnOrSelf(b.fill || null);
		b.dir = ifNull(b.dir, -1);
	});
	const xScaleKey = mode == 2 ? series[1].facets[0].scale : series[0].scale;
	const drawOrderMap = {
		axes: drawAxesGrid,
		series: drawSeries
	};
	const drawOrder = (opts.drawOrder || ["axes", "series"]).map((key) => drawOrderMap[key]);
	function initValToPct(sc) {
		const getVal = sc.distr == 3 ? (val) => log10(val > 0 ? val : sc.clamp(self, val, sc.min, sc.max, sc.key)) : sc.distr == 4 ? (val) => asinh(val, sc.asinh) : sc.distr == 100 ? (val) => sc.fwd(val) : (val) => val;
		return (val) => {
			let _val = getVal(val);
			let { _min, _max } = sc;
			let delta = _max - _min;
			return (_val - _min) / delta;
		};
	}
	function initScale(scaleKey) {
		let sc = scales[scaleKey];
		if (sc == null) {
			let scaleOpts = (opts.scales || EMPTY_OBJ)[scaleKey] || EMPTY_OBJ;
			if (scaleOpts.from != null) {
				initScale(scaleOpts.from);
				let sc = assign({}, scales[scaleOpts.from], scaleOpts, { key: scaleKey });
				sc.valToPct = initValToPct(sc);
				scales[scaleKey] = sc;
			} else {
				sc = scales[scaleKey] = assign({}, scaleKey == xScaleKey ? xScaleOpts : yScaleOpts, scaleOpts);
				sc.key = scaleKey;
				let isTime = sc.time;
				let rn = sc.range;
				let rangeIsArr = isArr(rn);
				if (scaleKey != xScaleKey || mode == 2 && !isTime) {
					if (rangeIsArr && (rn[0] == null || rn[1] == null)) {
						rn = {
							min: rn[0] == null ? autoRangePart : {
								mode: 1,
								hard: rn[0],
								soft: rn[0]
							},
							max: rn[1] == null ? autoRangePart : {
								mode: 1,
								hard: rn[1],
								soft: rn[1]
							}
						};
						rangeIsArr = false;
					}
					if (!rangeIsArr && isObj(rn)) {
						let cfg = rn;
						rn = (self, dataMin, dataMax) => dataMin == null ? nullNullTuple : rangeNum(dataMin, dataMax, cfg);
					}
				}
				sc.range = fnOrSelf(rn || (isTime ? snapTimeX : scaleKey == xScaleKey ? sc.distr == 3 ? snapLogX : sc.distr == 4 ? snapAsinhX : snapNumX : sc.distr == 3 ? snapLogY : sc.distr == 4 ? snapAsinhY : snapNumY));
				sc.auto = fnOrSelf(rangeIsArr ? false : sc.auto);
				sc.clamp = fnOrSelf(sc.clamp || clampScale);
				sc._min = sc._max = null;
				sc.valToPct = initValToPct(sc);
			}
		}
	}
	initScale("x");
	initScale("y");
	if (mode == 1) series.forEach((s) => {
		initScale(s.scale);
	});
	axes.forEach((a) => {
		initScale(a.scale);
	});
	for (let k in opts.scales) initScale(k);
	const scaleX = scales[xScaleKey];
	const xScaleDistr = scaleX.distr;
	let valToPosX, valToPosY;
	if (scaleX.ori == 0) {
		addClass(root, ORI_HZ);
		valToPosX = getHPos;
		valToPosY = getVPos;
	} else {
		addClass(root, ORI_VT);
		valToPosX = getVPos;
		valToPosY = getHPos;
	}
	const pendScales = {};
	for (let k in scales) {
		let sc = scales[k];
		if (sc.min != null || sc.max != null) {
			pendScales[k] = {
				min: sc.min,
				max: sc.max
			};
			sc.min = sc.max = null;
		}
	}
	const _tzDate = opts.tzDate || ((ts) => new Date(round$1(ts / ms)));
	const _fmtDate = opts.fmtDate || fmtDate;
	const _timeAxisSplits = ms == 1 ? timeAxisSplitsMs(_tzDate) : timeAxisSplitsS(_tzDate);
	const _timeAxisVals = timeAxisVals(_tzDate, timeAxisStamps(ms == 1 ? _timeAxisStampsMs : _timeAxisStampsS, _fmtDate));
	const _timeSeriesVal = timeSeriesVal(_tzDate, timeSeriesStamp(_timeSeriesStamp, _fmtDate));
	const activeIdxs = [];
	const legend = self.legend = assign({}, legendOpts, opts.legend);
	const cursor = self.cursor = assign({}, cursorOpts, { drag: { y: mode == 2 } }, opts.cursor);
	const showLegend = legend.show;
	const showCursor = cursor.show;
	const markers = legend.markers;
	legend.idxs = activeIdxs;
	markers.width = fnOrSelf(markers.width);
	markers.dash = fnOrSelf(markers.dash);
	markers.stroke = fnOrSelf(markers.stroke);
	markers.fill = fnOrSelf(markers.fill);
	let legendTable;
	let legendHead;
	let legendBody;
	let legendRows = [];
	let legendCells = [];
	let legendCols;
	let multiValLegend = false;
	let NULL_LEGEND_VALUES = {};
	if (legend.live) {
		const getMultiVals = series[1] ? series[1].values : null;
		multiValLegend = getMultiVals != null;
		legendCols = multiValLegend ? getMultiVals(self, 1, 0) : { _: 0 };
		for (let k in legendCols) NULL_LEGEND_VALUES[k] = LEGEND_DISP;
	}
	if (showLegend) {
		legendTable = placeTag("table", LEGEND, root);
		legendBody = placeTag("tbody", null, legendTable);
		legend.mount(self, legendTable);
		if (multiValLegend) {
			legendHead = placeTag("thead", null, legendTable, legendBody);
			let head = placeTag("tr", null, legendHead);
			placeTag("th", null, head);
			for (var key in legendCols) placeTag("th", LEGEND_LABEL, head).textContent = key;
		} else {
			addClass(legendTable, LEGEND_INLINE);
			legend.live && addClass(legendTable, LEGEND_LIVE);
		}
	}
	const son = { show: true };
	const soff = { show: false };
	function initLegendRow(s, i) {
		if (i == 0 && (multiValLegend || !legend.live || mode == 2)) return nullNullTuple;
		let cells = [];
		let row = placeTag("tr", LEGEND_SERIES, legendBody, legendBody.childNodes[i]);
		addClass(row, s.class);
		if (!s.show) addClass(row, OFF);
		let label = placeTag("th", null, row);
		if (markers.show) {
			let indic = placeDiv(LEGEND_MARKER, label);
			if (i > 0) {
				let width = markers.width(self, i);
				if (width) indic.style.border = width + "px " + markers.dash(self, i) + " " + markers.stroke(self, i);
				indic.style.background = markers.fill(self, i);
			}
		}
		let text = placeDiv(LEGEND_LABEL, label);
		if (s.label instanceof HTMLElement) text.appendChild(s.label);
		else text.textContent = s.label;
		if (i > 0) {
			if (!markers.show) text.style.color = s.width > 0 ? markers.stroke(self, i) : markers.fill(self, i);
			onMouse("click", label, (e) => {
				if (cursor._lock) return;
				setCursorEvent(e);
				let seriesIdx = series.indexOf(s);
				if ((e.ctrlKey || e.metaKey) != legend.isolate) {
					let isolate = series.some((s, i) => i > 0 && i != seriesIdx && s.show);
					series.forEach((s, i) => {
						i > 0 && setSeries(i, isolate ? i == seriesIdx ? son : soff : son, true, syncOpts.setSeries);
					});
				} else setSeries(seriesIdx, { show: !s.show }, true, syncOpts.setSeries);
			}, false);
			if (cursorFocus) onMouse(mouseenter, label, (e) => {
				if (cursor._lock) return;
				setCursorEvent(e);
				setSeries(series.indexOf(s), FOCUS_TRUE, true, syncOpts.setSeries);
			}, false);
		}
		for (var key in legendCols) {
			let v = placeTag("td", LEGEND_VALUE, row);
			v.textContent = "--";
			cells.push(v);
		}
		return [row, cells];
	}
	const mouseListeners = /* @__PURE__ */ new Map();
	function onMouse(ev, targ, fn, onlyTarg = true) {
		const targListeners = mouseListeners.get(targ) || {};
		const listener = cursor.bind[ev](self, targ, fn, onlyTarg);
		if (listener) {
			on(ev, targ, targListeners[ev] = listener);
			mouseListeners.set(targ, targListeners);
		}
	}
	function offMouse(ev, targ, fn) {
		const targListeners = mouseListeners.get(targ) || {};
		for (let k in targListeners) if (ev == null || k == ev) {
			off(k, targ, targListeners[k]);
			delete targListeners[k];
		}
		if (ev == null) mouseListeners.delete(targ);
	}
	let fullWidCss = 0;
	let fullHgtCss = 0;
	let plotWidCss = 0;
	let plotHgtCss = 0;
	let plotLftCss = 0;
	let plotTopCss = 0;
	let _plotLftCss = plotLftCss;
	let _plotTopCss = plotTopCss;
	let _plotWidCss = plotWidCss;
	let _plotHgtCss = plotHgtCss;
	let plotLft = 0;
	let plotTop = 0;
	let plotWid = 0;
	let plotHgt = 0;
	self.bbox = {};
	let shouldSetScales = false;
	let shouldSetSize = false;
	let shouldConvergeSize = false;
	let shouldSetCursor = false;
	let shouldSetSelect = false;
	let shouldSetLegend = false;
	function _setSize(width, height, force) {
		if (force || width != self.width || height != self.height) calcSize(width, height);
		resetYSeries(false);
		shouldConvergeSize = true;
		shouldSetSize = true;
		commit();
	}
	function calcSize(width, height) {
		self.width = fullWidCss = plotWidCss = width;
		self.height = fullHgtCss = plotHgtCss = height;
		plotLftCss = plotTopCss = 0;
		calcPlotRect();
		calcAxesRects();
		let bb = self.bbox;
		plotLft = bb.left = incrRound(plotLftCss * pxRatio, .5);
		plotTop = bb.top = incrRound(plotTopCss * pxRatio, .5);
		plotWid = bb.width = incrRound(plotWidCss * pxRatio, .5);
		plotHgt = bb.height = incrRound(plotHgtCss * pxRatio, .5);
	}
	const CYCLE_LIMIT = 3;
	function convergeSize() {
		let converged = false;
		let cycleNum = 0;
		while (!converged) {
			cycleNum++;
			let axesConverged = axesCalc(cycleNum);
			let paddingConverged = paddingCalc(cycleNum);
			converged = cycleNum == CYCLE_LIMIT || axesConverged && paddingConverged;
			if (!converged) {
				calcSize(self.width, self.height);
				shouldSetSize = true;
			}
		}
	}
	function setSize({ width, height }) {
		_setSize(width, height);
	}
	self.setSize = setSize;
	function calcPlotRect() {
		let hasTopAxis = false;
		let hasBtmAxis = false;
		let hasRgtAxis = false;
		let hasLftAxis = false;
		axes.forEach((axis, i) => {
			if (axis.show && axis._show) {
				let { side, _size } = axis;
				let isVt = side % 2;
				let fullSize = _size + (axis.label != null ? axis.labelSize : 0);
				if (fullSize > 0) {
					if (isVt) {
						plotWidCss -= fullSize;
						if (side == 3) {
							plotLftCss += fullSize;
							hasLftAxis = true;
						} else hasRgtAxis = true;
					} else {
						plotHgtCss -= fullSize;
						if (side == 0) {
							plotTopCss += fullSize;
							hasTopAxis = true;
						} else hasBtmAxis = true;
					}
				}
			}
		});
		sidesWithAxes[0] = hasTopAxis;
		sidesWithAxes[1] = hasRgtAxis;
		sidesWithAxes[2] = hasBtmAxis;
		sidesWithAxes[3] = hasLftAxis;
		plotWidCss -= _padding[1] + _padding[3];
		plotLftCss += _padding[3];
		plotHgtCss -= _padding[2] + _padding[0];
		plotTopCss += _padding[0];
	}
	function calcAxesRects() {
		let off1 = plotLftCss + plotWidCss;
		let off2 = plotTopCss + plotHgtCss;
		let off3 = plotLftCss;
		let off0 = plotTopCss;
		function incrOffset(side, size) {
			switch (side) {
				case 1:
					off1 += size;
					return off1 - size;
				case 2:
					off2 += size;
					return off2 - size;
				case 3:
					off3 -= size;
					return off3 + size;
				case 0:
					off0 -= size;
					return off0 + size;
			}
		}
		axes.forEach((axis, i) => {
			if (axis.show && axis._show) {
				let side = axis.side;
				axis._pos = incrOffset(side, axis._size);
				if (axis.label != null) axis._lpos = incrOffset(side, axis.labelSize);
			}
		});
	}
	if (cursor.dataIdx == null) {
		let hov = cursor.hover;
		let skip = hov.skip = new Set(hov.skip ?? []);
		skip.add(void 0);
		let prox = hov.prox = fnOrSelf(hov.prox);
		let bias = hov.bias ??= 0;
		cursor.dataIdx = (self, seriesIdx, cursorIdx, valAtPosX) => {
			if (seriesIdx == 0) return cursorIdx;
			let idx2 = cursorIdx;
			let _prox = prox(self, seriesIdx, cursorIdx, valAtPosX) ?? inf;
			let withProx = _prox >= 0 && _prox < inf;
			let xDim = scaleX.ori == 0 ? plotWidCss : plotHgtCss;
			let cursorLft = cursor.left;
			let xValues = data[0];
			let yValues = data[seriesIdx];
			if (skip.has(yValues[cursorIdx])) {
				idx2 = null;
				let nonNullLft = null, nonNullRgt = null, j;
				if (bias == 0 || bias == -1) {
					j = cursorIdx;
					while (nonNullLft == null && j-- > 0) if (!skip.has(yValues[j])) nonNullLft = j;
				}
				if (bias == 0 || bias == 1) {
					j = cursorIdx;
					while (nonNullRgt == null && j++ < yValues.length) if (!skip.has(yValues[j])) nonNullRgt = j;
				}
				if (nonNullLft != null || nonNullRgt != null) {
					if (withProx) {
						let lftPos = nonNullLft == null ? -Infinity : valToPosX(xValues[nonNullLft], scaleX, xDim, 0);
						let rgtPos = nonNullRgt == null ? Infinity : valToPosX(xValues[nonNullRgt], scaleX, xDim, 0);
						let lftDelta = cursorLft - lftPos;
						let rgtDelta = rgtPos - cursorLft;
						if (lftDelta <= rgtDelta) {
							if (lftDelta <= _prox) idx2 = nonNullLft;
						} else if (rgtDelta <= _prox) idx2 = nonNullRgt;
					} else idx2 = nonNullRgt == null ? nonNullLft : nonNullLft == null ? nonNullRgt : cursorIdx - nonNullLft <= nonNullRgt - cursorIdx ? nonNullLft : nonNullRgt;
				}
			} else if (withProx) {
				if (abs(cursorLft - valToPosX(xValues[cursorIdx], scaleX, xDim, 0)) > _prox) idx2 = null;
			}
			return idx2;
		};
	}
	const setCursorEvent = (e) => {
		cursor.event = e;
	};
	cursor.idxs = activeIdxs;
	cursor._lock = false;
	let points = cursor.points;
	points.show = fnOrSelf(points.show);
	points.size = fnOrSelf(points.size);
	points.stroke = fnOrSelf(points.stroke);
	points.width = fnOrSelf(points.width);
	points.fill = fnOrSelf(points.fill);
	const focus = self.focus = assign({}, opts.focus || { alpha: .3 }, cursor.focus);
	const cursorFocus = focus.prox >= 0;
	const cursorOnePt = cursorFocus && points.one;
	let cursorPts = [];
	let cursorPtsLft = [];
	let cursorPtsTop = [];
	function initCursorPt(s, si) {
		let pt = points.show(self, si);
		if (pt instanceof HTMLElement) {
			addClass(pt, CURSOR_PT);
			addClass(pt, s.class);
			elTrans(pt, -10, -10, plotWidCss, plotHgtCss);
			over.insertBefore(pt, cursorPts[si]);
			return pt;
		}
	}
	function initSeries(s, i) {
		if (mode == 1 || i > 0) {
			let isTime = mode == 1 && scales[s.scale].time;
			let sv = s.value;
			s.value = isTime ? isStr(sv) ? timeSeriesVal(_tzDate, timeSeriesStamp(sv, _fmtDate)) : sv || _timeSeriesVal : sv || numSeriesVal;
			s.label = s.label || (isTime ? timeSeriesLabel : numSeriesLabel);
		}
		if (cursorOnePt || i > 0) {
			s.width = s.width == null ? 1 : s.width;
			s.paths = s.paths || linearPath || retNull;
			s.fillTo = fnOrSelf(s.fillTo || seriesFillTo);
			s.pxAlign = +ifNull(s.pxAlign, pxAlign);
			s.pxRound = pxRoundGen(s.pxAlign);
			s.stroke = fnOrSelf(s.stroke || null);
			s.fill = fnOrSelf(s.fill || null);
			s._stroke = s._fill = s._paths = s._focus = null;
			let _ptDia = ptDia(max(1, s.width), 1);
			let points = s.points = assign({}, {
				size: _ptDia,
				width: max(1, _ptDia * .2),
				stroke: s.stroke,
				space: _ptDia * 2,
				paths: pointsPath,
				_stroke: null,
				_fill: null
			}, s.points);
			points.show = fnOrSelf(points.show);
			points.filter = fnOrSelf(points.filter);
			points.fill = fnOrSelf(points.fill);
			points.stroke = fnOrSelf(points.stroke);
			points.paths = fnOrSelf(points.paths);
			points.pxAlign = s.pxAlign;
		}
		if (showLegend) {
			let rowCells = initLegendRow(s, i);
			legendRows.splice(i, 0, rowCells[0]);
			legendCells.splice(i, 0, rowCells[1]);
			legend.values.push(null);
		}
		if (showCursor) {
			activeIdxs.splice(i, 0, null);
			let pt = null;
			if (cursorOnePt) {
				if (i == 0) pt = initCursorPt(s, i);
			} else if (i > 0) pt = initCursorPt(s, i);
			cursorPts.splice(i, 0, pt);
			cursorPtsLft.splice(i, 0, 0);
			cursorPtsTop.splice(i, 0, 0);
		}
		fire("addSeries", i);
	}
	function addSeries(opts, si) {
		si = si == null ? series.length : si;
		opts = mode == 1 ? setDefault(opts, si, xSeriesOpts, ySeriesOpts) : setDefault(opts, si, {}, xySeriesOpts);
		series.splice(si, 0, opts);
		initSeries(series[si], si);
	}
	self.addSeries = addSeries;
	function delSeries(i) {
		series.splice(i, 1);
		if (showLegend) {
			legend.values.splice(i, 1);
			legendCells.splice(i, 1);
			let tr = legendRows.splice(i, 1)[0];
			offMouse(null, tr.firstChild);
			tr.remove();
		}
		if (showCursor) {
			activeIdxs.splice(i, 1);
			cursorPts.splice(i, 1)[0].remove();
			cursorPtsLft.splice(i, 1);
			cursorPtsTop.splice(i, 1);
		}
		fire("delSeries", i);
	}
	self.delSeries = delSeries;
	const sidesWithAxes = [
		false,
		false,
		false,
		false
	];
	function initAxis(axis, i) {
		axis._show = axis.show;
		if (axis.show) {
			let isVt = axis.side % 2;
			let sc = scales[axis.scale];
			if (sc == null) {
				axis.scale = isVt ? series[1].scale : xScaleKey;
				sc = scales[axis.scale];
			}
			let isTime = sc.time;
			axis.size = fnOrSelf(axis.size);
			axis.space = fnOrSelf(axis.space);
			axis.rotate = fnOrSelf(axis.rotate);
			if (isArr(axis.incrs)) axis.incrs.forEach((incr) => {
				!fixedDec.has(incr) && fixedDec.set(incr, guessDec(incr));
			});
			axis.incrs = fnOrSelf(axis.incrs || (sc.distr == 2 ? wholeIncrs : isTime ? ms == 1 ? timeIncrsMs : timeIncrsS : numIncrs));
			axis.splits = fnOrSelf(axis.splits || (isTime && sc.distr == 1 ? _timeAxisSplits : sc.distr == 3 ? logAxisSplits : sc.distr == 4 ? asinhAxisSplits : numAxisSplits));
			axis.stroke = fnOrSelf(axis.stroke);
			axis.grid.stroke = fnOrSelf(axis.grid.stroke);
			axis.ticks.stroke = fnOrSelf(axis.ticks.stroke);
			axis.border.stroke = fnOrSelf(axis.border.stroke);
			let av = axis.values;
			axis.values = isArr(av) && !isArr(av[0]) ? fnOrSelf(av) : isTime ? isArr(av) ? timeAxisVals(_tzDate, timeAxisStamps(av, _fmtDate)) : isStr(av) ? timeAxisVal(_tzDate, av) : av || _timeAxisVals : av || numAxisVals;
			axis.filter = fnOrSelf(axis.filter || (sc.distr >= 3 && sc.log == 10 ? log10AxisValsFilt : sc.distr == 3 && sc.log == 2 ? log2AxisValsFilt : retArg1));
			axis.font = pxRatioFont(axis.font);
			axis.labelFont = pxRatioFont(axis.labelFont);
			axis._size = axis.size(self, null, i, 0);
			axis._space = axis._rotate = axis._incrs = axis._found = axis._splits = axis._values = null;
			if (axis._size > 0) {
				sidesWithAxes[i] = true;
				axis._el = placeDiv(AXIS, wrap);
			}
		}
	}
	function autoPadSide(self, side, sidesWithAxes, cycleNum) {
		let [hasTopAxis, hasRgtAxis, hasBtmAxis, hasLftAxis] = sidesWithAxes;
		let ori = side % 2;
		let size = 0;
		if (ori == 0 && (hasLftAxis || hasRgtAxis)) size = side == 0 && !hasTopAxis || side == 2 && !hasBtmAxis ? round$1(xAxisOpts.size / 3) : 0;
		if (ori == 1 && (hasTopAxis || hasBtmAxis)) size = side == 1 && !hasRgtAxis || side == 3 && !hasLftAxis ? round$1(yAxisOpts.size / 2) : 0;
		return size;
	}
	const padding = self.padding = (opts.padding || [
		autoPadSide,
		autoPadSide,
		autoPadSide,
		autoPadSide
	]).map((p) => fnOrSelf(ifNull(p, autoPadSide)));
	const _padding = self._padding = padding.map((p, i) => p(self, i, sidesWithAxes, 0));
	let dataLen;
	let i0 = null;
	let i1 = null;
	const idxs = mode == 1 ? series[0].idxs : null;
	let data0 = null;
	let viaAutoScaleX = false;
	function setData(_data, _resetScales) {
		data = _data == null ? [] : _data;
		self.data = self._data = data;
		if (mode == 2) {
			dataLen = 0;
			for (let i = 1; i < series.length; i++) dataLen += data[i][0].length;
		} else {
			if (data.length == 0) self.data = self._data = data = [[]];
			data0 = data[0];
			dataLen = data0.length;
			let scaleData = data;
			if (xScaleDistr == 2) {
				scaleData = data.slice();
				let _data0 = scaleData[0] = Array(dataLen);
				for (let i = 0; i < dataLen; i++) _data0[i] = i;
			}
			self._data = data = scaleData;
		}
		resetYSeries(true);
		fire("setData");
		if (xScaleDistr == 2) shouldConvergeSize = true;
		if (_resetScales !== false) {
			let xsc = scaleX;
			if (xsc.auto(self, viaAutoScaleX)) autoScaleX();
			else _setScale(xScaleKey, xsc.min, xsc.max);
			shouldSetCursor = shouldSetCursor || cursor.left >= 0;
			shouldSetLegend = true;
			commit();
		}
	}
	self.setData = setData;
	function autoScaleX() {
		viaAutoScaleX = true;
		let _min, _max;
		if (mode == 1) {
			if (dataLen > 0) {
				i0 = idxs[0] = 0;
				i1 = idxs[1] = dataLen - 1;
				_min = data[0][i0];
				_max = data[0][i1];
				if (xScaleDistr == 2) {
					_min = i0;
					_max = i1;
				} else if (_min == _max) {
					if (xScaleDistr == 3) [_min, _max] = rangeLog(_min, _min, scaleX.log, false);
					else if (xScaleDistr == 4) [_min, _max] = rangeAsinh(_min, _min, scaleX.log, false);
					else if (scaleX.time) _max = _min + round$1(86400 / ms);
					else [_min, _max] = rangeNum(_min, _max, rangePad, true);
				}
			} else {
				i0 = idxs[0] = _min = null;
				i1 = idxs[1] = _max = null;
			}
		}
		_setScale(xScaleKey, _min, _max);
	}
	let ctxStroke, ctxFill, ctxWidth, ctxDash, ctxJoin, ctxCap, ctxFont, ctxAlign, ctxBaseline;
	let ctxAlpha;
	function setCtxStyle(stroke, width, dash, cap, fill, join) {
		stroke ??= transparent;
		dash ??= EMPTY_ARR;
		cap ??= "butt";
		fill ??= transparent;
		join ??= "round";
		if (stroke != ctxStroke) ctx.strokeStyle = ctxStroke = stroke;
		if (fill != ctxFill) ctx.fillStyle = ctxFill = fill;
		if (width != ctxWidth) ctx.lineWidth = ctxWidth = width;
		if (join != ctxJoin) ctx.lineJoin = ctxJoin = join;
		if (cap != ctxCap) ctx.lineCap = ctxCap = cap;
		if (dash != ctxDash) ctx.setLineDash(ctxDash = dash);
	}
	function setFontStyle(font, fill, align, baseline) {
		if (fill != ctxFill) ctx.fillStyle = ctxFill = fill;
		if (font != ctxFont) ctx.font = ctxFont = font;
		if (align != ctxAlign) ctx.textAlign = ctxAlign = align;
		if (baseline != ctxBaseline) ctx.textBaseline = ctxBaseline = baseline;
	}
	function accScale(wsc, psc, facet, data, sorted = 0) {
		if (data.length > 0 && wsc.auto(self, viaAutoScaleX) && (psc == null || psc.min == null)) {
			let _i0 = ifNull(i0, 0);
			let _i1 = ifNull(i1, data.length - 1);
			let minMax = facet.min == null ? getMinMax(data, _i0, _i1, sorted, wsc.distr == 3) : [facet.min, facet.max];
			wsc.min = min(wsc.min, facet.min = minMax[0]);
			wsc.max = max(wsc.max, facet.max = minMax[1]);
		}
	}
	const AUTOSCALE = {
		min: null,
		max: null
	};
	function setScales() {
		for (let k in scales) {
			let sc = scales[k];
			if (pendScales[k] == null && (sc.min == null || pendScales[xScaleKey] != null && sc.auto(self, viaAutoScaleX))) pendScales[k] = AUTOSCALE;
		}
		for (let k in scales) {
			let sc = scales[k];
			if (pendScales[k] == null && sc.from != null && pendScales[sc.from] != null) pendScales[k] = AUTOSCALE;
		}
		if (pendScales[xScaleKey] != null) resetYSeries(true);
		let wipScales = {};
		for (let k in pendScales) {
			let psc = pendScales[k];
			if (psc != null) {
				let wsc = wipScales[k] = copy(scales[k], fastIsObj);
				if (psc.min != null) assign(wsc, psc);
				else if (k != xScaleKey || mode == 2) {
					if (dataLen == 0 && wsc.from == null) {
						let minMax = wsc.range(self, null, null, k);
						wsc.min = minMax[0];
						wsc.max = minMax[1];
					} else {
						wsc.min = inf;
						wsc.max = -Infinity;
					}
				}
			}
		}
		if (dataLen > 0) {
			series.forEach((s, i) => {
				if (mode == 1) {
					let k = s.scale;
					let psc = pendScales[k];
					if (psc == null) return;
					let wsc = wipScales[k];
					if (i == 0) {
						let minMax = wsc.range(self, wsc.min, wsc.max, k);
						wsc.min = minMax[0];
						wsc.max = minMax[1];
						i0 = closestIdx(wsc.min, data[0]);
						i1 = closestIdx(wsc.max, data[0]);
						if (i1 - i0 > 1) {
							if (data[0][i0] < wsc.min) i0++;
							if (data[0][i1] > wsc.max) i1--;
						}
						s.min = data0[i0];
						s.max = data0[i1];
					} else if (s.show && s.auto) accScale(wsc, psc, s, data[i], s.sorted);
					s.idxs[0] = i0;
					s.idxs[1] = i1;
				} else if (i > 0) {
					if (s.show && s.auto) {
						let [xFacet, yFacet] = s.facets;
						let xScaleKey = xFacet.scale;
						let yScaleKey = yFacet.scale;
						let [xData, yData] = data[i];
						let wscx = wipScales[xScaleKey];
						let wscy = wipScales[yScaleKey];
						wscx != null && accScale(wscx, pendScales[xScaleKey], xFacet, xData, xFacet.sorted);
						wscy != null && accScale(wscy, pendScales[yScaleKey], yFacet, yData, yFacet.sorted);
						s.min = yFacet.min;
						s.max = yFacet.max;
					}
				}
			});
			for (let k in wipScales) {
				let wsc = wipScales[k];
				let psc = pendScales[k];
				if (wsc.from == null && (psc == null || psc.min == null)) {
					let minMax = wsc.range(self, wsc.min == inf ? null : wsc.min, wsc.max == -Infinity ? null : wsc.max, k);
					wsc.min = minMax[0];
					wsc.max = minMax[1];
				}
			}
		}
		for (let k in wipScales) {
			let wsc = wipScales[k];
			if (wsc.from != null) {
				let base = wipScales[wsc.from];
				if (base.min == null) wsc.min = wsc.max = null;
				else {
					let minMax = wsc.range(self, base.min, base.max, k);
					wsc.min = minMax[0];
					wsc.max = minMax[1];
				}
			}
		}
		let changed = {};
		let anyChanged = false;
		for (let k in wipScales) {
			let wsc = wipScales[k];
			let sc = scales[k];
			if (sc.min != wsc.min || sc.max != wsc.max) {
				sc.min = wsc.min;
				sc.max = wsc.max;
				let distr = sc.distr;
				sc._min = distr == 3 ? log10(sc.min) : distr == 4 ? asinh(sc.min, sc.asinh) : distr == 100 ? sc.fwd(sc.min) : sc.min;
				sc._max = distr == 3 ? log10(sc.max) : distr == 4 ? asinh(sc.max, sc.asinh) : distr == 100 ? sc.fwd(sc.max) : sc.max;
				changed[k] = anyChanged = true;
			}
		}
		if (anyChanged) {
			series.forEach((s, i) => {
				if (mode == 2) {
					if (i > 0 && changed.y) s._paths = null;
				} else if (changed[s.scale]) s._paths = null;
			});
			for (let k in changed) {
				shouldConvergeSize = true;
				fire("setScale", k);
			}
			if (showCursor && cursor.left >= 0) shouldSetCursor = shouldSetLegend = true;
		}
		for (let k in pendScales) pendScales[k] = null;
	}
	function getOuterIdxs(ydata) {
		let _i0 = clamp(i0 - 1, 0, dataLen - 1);
		let _i1 = clamp(i1 + 1, 0, dataLen - 1);
		while (ydata[_i0] == null && _i0 > 0) _i0--;
		while (ydata[_i1] == null && _i1 < dataLen - 1) _i1++;
		return [_i0, _i1];
	}
	function drawSeries() {
		if (dataLen > 0) {
			let shouldAlpha = series.some((s) => s._focus) && ctxAlpha != focus.alpha;
			if (shouldAlpha) ctx.globalAlpha = ctxAlpha = focus.alpha;
			series.forEach((s, i) => {
				if (i > 0 && s.show) {
					cacheStrokeFill(i, false);
					cacheStrokeFill(i, true);
					if (s._paths == null) {
						let _ctxAlpha = ctxAlpha;
						if (ctxAlpha != s.alpha) ctx.globalAlpha = ctxAlpha = s.alpha;
						let _idxs = mode == 2 ? [0, data[i][0].length - 1] : getOuterIdxs(data[i]);
						s._paths = s.paths(self, i, _idxs[0], _idxs[1]);
						if (ctxAlpha != _ctxAlpha) ctx.globalAlpha = ctxAlpha = _ctxAlpha;
					}
				}
			});
			series.forEach((s, i) => {
				if (i > 0 && s.show) {
					let _ctxAlpha = ctxAlpha;
					if (ctxAlpha != s.alpha) ctx.globalAlpha = ctxAlpha = s.alpha;
					s._paths != null && drawPath(i, false);
					{
						let _gaps = s._paths != null ? s._paths.gaps : null;
						let show = s.points.show(self, i, i0, i1, _gaps);
						let idxs = s.points.filter(self, i, show, _gaps);
						if (show || idxs) {
							s.points._paths = s.points.paths(self, i, i0, i1, idxs);
							drawPath(i, true);
						}
					}
					if (ctxAlpha != _ctxAlpha) ctx.globalAlpha = ctxAlpha = _ctxAlpha;
					fire("drawSeries", i);
				}
			});
			if (shouldAlpha) ctx.globalAlpha = ctxAlpha = 1;
		}
	}
	function cacheStrokeFill(si, _points) {
		let s = _points ? series[si].points : series[si];
		s._stroke = s.stroke(self, si);
		s._fill = s.fill(self, si);
	}
	function drawPath(si, _points) {
		let s = _points ? series[si].points : series[si];
		let { stroke, fill, clip: gapsClip, flags, _stroke: strokeStyle = s._stroke, _fill: fillStyle = s._fill, _width: width = s.width } = s._paths;
		width = roundDec(width * pxRatio, 3);
		let boundsClip = null;
		let offset = width % 2 / 2;
		if (_points && fillStyle == null) fillStyle = width > 0 ? "#fff" : strokeStyle;
		let _pxAlign = s.pxAlign == 1 && offset > 0;
		_pxAlign && ctx.translate(offset, offset);
		if (!_points) {
			let lft = plotLft - width / 2, top = plotTop - width / 2, wid = plotWid + width, hgt = plotHgt + width;
			boundsClip = new Path2D();
			boundsClip.rect(lft, top, wid, hgt);
		}
		if (_points) strokeFill(strokeStyle, width, s.dash, s.cap, fillStyle, stroke, fill, flags, gapsClip);
		else fillStroke(si, strokeStyle, width, s.dash, s.cap, fillStyle, stroke, fill, flags, boundsClip, gapsClip);
		_pxAlign && ctx.translate(-offset, -offset);
	}
	function fillStroke(si, strokeStyle, lineWidth, lineDash, lineCap, fillStyle, strokePath, fillPath, flags, boundsClip, gapsClip) {
		let didStrokeFill = false;
		flags != 0 && bands.forEach((b, bi) => {
			if (b.series[0] == si) {
				let lowerEdge = series[b.series[1]];
				let lowerData = data[b.series[1]];
				let bandClip = (lowerEdge._paths || EMPTY_OBJ).band;
				if (isArr(bandClip)) bandClip = b.dir == 1 ? bandClip[0] : bandClip[1];
				let gapsClip2;
				let _fillStyle = null;
				if (lowerEdge.show && bandClip && hasData(lowerData, i0, i1)) {
					_fillStyle = b.fill(self, bi) || fillStyle;
					gapsClip2 = lowerEdge._paths.clip;
				} else bandClip = null;
				strokeFill(strokeStyle, lineWidth, lineDash, lineCap, _fillStyle, strokePath, fillPath, flags, boundsClip, gapsClip, gapsClip2, bandClip);
				didStrokeFill = true;
			}
		});
		if (!didStrokeFill) strokeFill(strokeStyle, lineWidth, lineDash, lineCap, fillStyle, strokePath, fillPath, flags, boundsClip, gapsClip);
	}
	const CLIP_FILL_STROKE = 3;
	function strokeFill(strokeStyle, lineWidth, lineDash, lineCap, fillStyle, strokePath, fillPath, flags, boundsClip, gapsClip, gapsClip2, bandClip) {
		setCtxStyle(strokeStyle, lineWidth, lineDash, lineCap, fillStyle);
		if (boundsClip || gapsClip || bandClip) {
			ctx.save();
			boundsClip && ctx.clip(boundsClip);
			gapsClip && ctx.clip(gapsClip);
		}
		if (bandClip) {
			if ((flags & CLIP_FILL_STROKE) == CLIP_FILL_STROKE) {
				ctx.clip(bandClip);
				gapsClip2 && ctx.clip(gapsClip2);
				doFill(fillStyle, fillPath);
				doStroke(strokeStyle, strokePath, lineWidth);
			} else if (flags & BAND_CLIP_STROKE) {
				doFill(fillStyle, fillPath);
				ctx.clip(bandClip);
				doStroke(strokeStyle, strokePath, lineWidth);
			} else if (flags & BAND_CLIP_FILL) {
				ctx.save();
				ctx.clip(bandClip);
				gapsClip2 && ctx.clip(gapsClip2);
				doFill(fillStyle, fillPath);
				ctx.restore();
				doStroke(strokeStyle, strokePath, lineWidth);
			}
		} else {
			doFill(fillStyle, fillPath);
			doStroke(strokeStyle, strokePath, lineWidth);
		}
		if (boundsClip || gapsClip || bandClip) ctx.restore();
	}
	function doStroke(strokeStyle, strokePath, lineWidth) {
		if (lineWidth > 0) {
			if (strokePath instanceof Map) strokePath.forEach((strokePath, strokeStyle) => {
				ctx.strokeStyle = ctxStroke = strokeStyle;
				ctx.stroke(strokePath);
			});
			else strokePath != null && strokeStyle && ctx.stroke(strokePath);
		}
	}
	function doFill(fillStyle, fillPath) {
		if (fillPath instanceof Map) fillPath.forEach((fillPath, fillStyle) => {
			ctx.fillStyle = ctxFill = fillStyle;
			ctx.fill(fillPath);
		});
		else fillPath != null && fillStyle && ctx.fill(fillPath);
	}
	function getIncrSpace(axisIdx, min, max, fullDim) {
		let axis = axes[axisIdx];
		let incrSpace;
		if (fullDim <= 0) incrSpace = [0, 0];
		else {
			let minSpace = axis._space = axis.space(self, axisIdx, min, max, fullDim);
			incrSpace = findIncr(min, max, axis._incrs = axis.incrs(self, axisIdx, min, max, fullDim, minSpace), fullDim, minSpace);
		}
		return axis._found = incrSpace;
	}
	function drawOrthoLines(offs, filts, ori, side, pos0, len, width, stroke, dash, cap) {
		let offset = width % 2 / 2;
		pxAlign == 1 && ctx.translate(offset, offset);
		setCtxStyle(stroke, width, dash, cap, stroke);
		ctx.beginPath();
		let x0, y0, x1, y1, pos1 = pos0 + (side == 0 || side == 3 ? -len : len);
		if (ori == 0) {
			y0 = pos0;
			y1 = pos1;
		} else {
			x0 = pos0;
			x1 = pos1;
		}
		for (let i = 0; i < offs.length; i++) if (filts[i] != null) {
			if (ori == 0) x0 = x1 = offs[i];
			else y0 = y1 = offs[i];
			ctx.moveTo(x0, y0);
			ctx.lineTo(x1, y1);
		}
		ctx.stroke();
		pxAlign == 1 && ctx.translate(-offset, -offset);
	}
	function axesCalc(cycleNum) {
		let converged = true;
		axes.forEach((axis, i) => {
			if (!axis.show) return;
			let scale = scales[axis.scale];
			if (scale.min == null) {
				if (axis._show) {
					converged = false;
					axis._show = false;
					resetYSeries(false);
				}
				return;
			} else if (!axis._show) {
				converged = false;
				axis._show = true;
				resetYSeries(false);
			}
			let side = axis.side;
			let ori = side % 2;
			let { min, max } = scale;
			let [_incr, _space] = getIncrSpace(i, min, max, ori == 0 ? plotWidCss : plotHgtCss);
			if (_space == 0) return;
			let forceMin = scale.distr == 2;
			let _splits = axis._splits = axis.splits(self, i, min, max, _incr, _space, forceMin);
			let splits = scale.distr == 2 ? _splits.map((i) => data0[i]) : _splits;
			let incr = scale.distr == 2 ? data0[_splits[1]] - data0[_splits[0]] : _incr;
			let values = axis._values = axis.values(self, axis.filter(self, splits, i, _space, incr), i, _space, incr);
			axis._rotate = side == 2 ? axis.rotate(self, values, i, _space) : 0;
			let oldSize = axis._size;
			axis._size = ceil(axis.size(self, values, i, cycleNum));
			if (oldSize != null && axis._size != oldSize) converged = false;
		});
		return converged;
	}
	function paddingCalc(cycleNum) {
		let converged = true;
		padding.forEach((p, i) => {
			let _p = p(self, i, sidesWithAxes, cycleNum);
			if (_p != _padding[i]) converged = false;
			_padding[i] = _p;
		});
		return converged;
	}
	function drawAxesGrid() {
		for (let i = 0; i < axes.length; i++) {
			let axis = axes[i];
			if (!axis.show || !axis._show) continue;
			let side = axis.side;
			let ori = side % 2;
			let x, y;
			let fillStyle = axis.stroke(self, i);
			let shiftDir = side == 0 || side == 3 ? -1 : 1;
			let [_incr, _space] = axis._found;
			if (axis.label != null) {
				let shiftAmt = axis.labelGap * shiftDir;
				let baseLpos = round$1((axis._lpos + shiftAmt) * pxRatio);
				setFontStyle(axis.labelFont[0], fillStyle, "center", side == 2 ? TOP : BOTTOM);
				ctx.save();
				if (ori == 1) {
					x = y = 0;
					ctx.translate(baseLpos, round$1(plotTop + plotHgt / 2));
					ctx.rotate((side == 3 ? -PI : PI) / 2);
				} else {
					x = round$1(plotLft + plotWid / 2);
					y = baseLpos;
				}
				let _label = isFn(axis.label) ? axis.label(self, i, _incr, _space) : axis.label;
				ctx.fillText(_label, x, y);
				ctx.restore();
			}
			if (_space == 0) continue;
			let scale = scales[axis.scale];
			let plotDim = ori == 0 ? plotWid : plotHgt;
			let plotOff = ori == 0 ? plotLft : plotTop;
			let _splits = axis._splits;
			let splits = scale.distr == 2 ? _splits.map((i) => data0[i]) : _splits;
			let incr = scale.distr == 2 ? data0[_splits[1]] - data0[_splits[0]] : _incr;
			let ticks = axis.ticks;
			let border = axis.border;
			let _tickSize = ticks.show ? ticks.size : 0;
			let tickSize = round$1(_tickSize * pxRatio);
			let axisGap = round$1((axis.alignTo == 2 ? axis._size - _tickSize - axis.gap : axis.gap) * pxRatio);
			let angle = axis._rotate * -PI / 180;
			let basePos = pxRound(axis._pos * pxRatio);
			let finalPos = basePos + (tickSize + axisGap) * shiftDir;
			y = ori == 0 ? finalPos : 0;
			x = ori == 1 ? finalPos : 0;
			let font = axis.font[0];
			setFontStyle(font, fillStyle, axis.align == 1 ? LEFT : axis.align == 2 ? RIGHT : angle > 0 ? LEFT : angle < 0 ? RIGHT : ori == 0 ? "center" : side == 3 ? RIGHT : LEFT, angle || ori == 1 ? "middle" : side == 2 ? TOP : BOTTOM);
			let lineHeight = axis.font[1] * axis.lineGap;
			let canOffs = _splits.map((val) => pxRound(getPos(val, scale, plotDim, plotOff)));
			let _values = axis._values;
			for (let i = 0; i < _values.length; i++) {
				let val = _values[i];
				if (val != null) {
					if (ori == 0) x = canOffs[i];
					else y = canOffs[i];
					val = "" + val;
					let _parts = val.indexOf("\n") == -1 ? [val] : val.split(/\n/gm);
					for (let j = 0; j < _parts.length; j++) {
						let text = _parts[j];
						if (angle) {
							ctx.save();
							ctx.translate(x, y + j * lineHeight);
							ctx.rotate(angle);
							ctx.fillText(text, 0, 0);
							ctx.restore();
						} else ctx.fillText(text, x, y + j * lineHeight);
					}
				}
			}
			if (ticks.show) drawOrthoLines(canOffs, ticks.filter(self, splits, i, _space, incr), ori, side, basePos, tickSize, roundDec(ticks.width * pxRatio, 3), ticks.stroke(self, i), ticks.dash, ticks.cap);
			let grid = axis.grid;
			if (grid.show) drawOrthoLines(canOffs, grid.filter(self, splits, i, _space, incr), ori, ori == 0 ? 2 : 1, ori == 0 ? plotTop : plotLft, ori == 0 ? plotHgt : plotWid, roundDec(grid.width * pxRatio, 3), grid.stroke(self, i), grid.dash, grid.cap);
			if (border.show) drawOrthoLines([basePos], [1], ori == 0 ? 1 : 0, ori == 0 ? 1 : 2, ori == 1 ? plotTop : plotLft, ori == 1 ? plotHgt : plotWid, roundDec(border.width * pxRatio, 3), border.stroke(self, i), border.dash, border.cap);
		}
		fire("drawAxes");
	}
	function resetYSeries(minMax) {
		series.forEach((s, i) => {
			if (i > 0) {
				s._paths = null;
				if (minMax) {
					if (mode == 1) {
						s.min = null;
						s.max = null;
					} else s.facets.forEach((f) => {
						f.min = null;
						f.max = null;
					});
				}
			}
		});
	}
	let queuedCommit = false;
	let deferHooks = false;
	let hooksQueue = [];
	function flushHooks() {
		deferHooks = false;
		for (let i = 0; i < hooksQueue.length; i++) fire(...hooksQueue[i]);
		hooksQueue.length = 0;
	}
	function commit() {
		if (!queuedCommit) {
			microTask(_commit);
			queuedCommit = true;
		}
	}
	function batch(fn, _deferHooks = false) {
		queuedCommit = true;
		deferHooks = _deferHooks;
		fn(self);
		_commit();
		if (_deferHooks && hooksQueue.length > 0) queueMicrotask(flushHooks);
	}
	self.batch = batch;
	function _commit() {
		if (shouldSetScales) {
			setScales();
			shouldSetScales = false;
		}
		if (shouldConvergeSize) {
			convergeSize();
			shouldConvergeSize = false;
		}
		if (shouldSetSize) {
			setStylePx(under, LEFT, plotLftCss);
			setStylePx(under, TOP, plotTopCss);
			setStylePx(under, WIDTH, plotWidCss);
			setStylePx(under, HEIGHT$2, plotHgtCss);
			setStylePx(over, LEFT, plotLftCss);
			setStylePx(over, TOP, plotTopCss);
			setStylePx(over, WIDTH, plotWidCss);
			setStylePx(over, HEIGHT$2, plotHgtCss);
			setStylePx(wrap, WIDTH, fullWidCss);
			setStylePx(wrap, HEIGHT$2, fullHgtCss);
			can.width = round$1(fullWidCss * pxRatio);
			can.height = round$1(fullHgtCss * pxRatio);
			axes.forEach(({ _el, _show, _size, _pos, side }) => {
				if (_el != null) {
					if (_show) {
						let posOffset = side === 3 || side === 0 ? _size : 0;
						let isVt = side % 2 == 1;
						setStylePx(_el, isVt ? "left" : "top", _pos - posOffset);
						setStylePx(_el, isVt ? "width" : "height", _size);
						setStylePx(_el, isVt ? "top" : "left", isVt ? plotTopCss : plotLftCss);
						setStylePx(_el, isVt ? "height" : "width", isVt ? plotHgtCss : plotWidCss);
						remClass(_el, OFF);
					} else addClass(_el, OFF);
				}
			});
			ctxStroke = ctxFill = ctxWidth = ctxJoin = ctxCap = ctxFont = ctxAlign = ctxBaseline = ctxDash = null;
			ctxAlpha = 1;
			syncRect(true);
			if (plotLftCss != _plotLftCss || plotTopCss != _plotTopCss || plotWidCss != _plotWidCss || plotHgtCss != _plotHgtCss) {
				resetYSeries(false);
				let pctWid = plotWidCss / _plotWidCss;
				let pctHgt = plotHgtCss / _plotHgtCss;
				if (showCursor && !shouldSetCursor && cursor.left >= 0) {
					cursor.left *= pctWid;
					cursor.top *= pctHgt;
					vCursor && elTrans(vCursor, round$1(cursor.left), 0, plotWidCss, plotHgtCss);
					hCursor && elTrans(hCursor, 0, round$1(cursor.top), plotWidCss, plotHgtCss);
					for (let i = 0; i < cursorPts.length; i++) {
						let pt = cursorPts[i];
						if (pt != null) {
							cursorPtsLft[i] *= pctWid;
							cursorPtsTop[i] *= pctHgt;
							elTrans(pt, ceil(cursorPtsLft[i]), ceil(cursorPtsTop[i]), plotWidCss, plotHgtCss);
						}
					}
				}
				if (select.show && !shouldSetSelect && select.left >= 0 && select.width > 0) {
					select.left *= pctWid;
					select.width *= pctWid;
					select.top *= pctHgt;
					select.height *= pctHgt;
					for (let prop in _hideProps) setStylePx(selectDiv, prop, select[prop]);
				}
				_plotLftCss = plotLftCss;
				_plotTopCss = plotTopCss;
				_plotWidCss = plotWidCss;
				_plotHgtCss = plotHgtCss;
			}
			fire("setSize");
			shouldSetSize = false;
		}
		if (fullWidCss > 0 && fullHgtCss > 0) {
			ctx.clearRect(0, 0, can.width, can.height);
			fire("drawClear");
			drawOrder.forEach((fn) => fn());
			fire("draw");
		}
		if (select.show && shouldSetSelect) {
			setSelect(select);
			shouldSetSelect = false;
		}
		if (showCursor && shouldSetCursor) {
			updateCursor(null, true, false);
			shouldSetCursor = false;
		}
		if (legend.show && legend.live && shouldSetLegend) {
			setLegend();
			shouldSetLegend = false;
		}
		if (!ready) {
			ready = true;
			self.status = 1;
			fire("ready");
		}
		viaAutoScaleX = false;
		queuedCommit = false;
	}
	self.redraw = (rebuildPaths, recalcAxes) => {
		shouldConvergeSize = recalcAxes || false;
		if (rebuildPaths !== false) _setScale(xScaleKey, scaleX.min, scaleX.max);
		else commit();
	};
	function setScale(key, opts) {
		let sc = scales[key];
		if (sc.from == null) {
			if (dataLen == 0) {
				let minMax = sc.range(self, opts.min, opts.max, key);
				opts.min = minMax[0];
				opts.max = minMax[1];
			}
			if (opts.min > opts.max) {
				let _min = opts.min;
				opts.min = opts.max;
				opts.max = _min;
			}
			if (dataLen > 1 && opts.min != null && opts.max != null && opts.max - opts.min < 1e-16) return;
			if (key == xScaleKey) {
				if (sc.distr == 2 && dataLen > 0) {
					opts.min = closestIdx(opts.min, data[0]);
					opts.max = closestIdx(opts.max, data[0]);
					if (opts.min == opts.max) opts.max++;
				}
			}
			pendScales[key] = opts;
			shouldSetScales = true;
			commit();
		}
	}
	self.setScale = setScale;
	let xCursor;
	let yCursor;
	let vCursor;
	let hCursor;
	let rawMouseLeft0;
	let rawMouseTop0;
	let mouseLeft0;
	let mouseTop0;
	let rawMouseLeft1;
	let rawMouseTop1;
	let mouseLeft1;
	let mouseTop1;
	let dragging = false;
	const drag = cursor.drag;
	let dragX = drag.x;
	let dragY = drag.y;
	if (showCursor) {
		if (cursor.x) xCursor = placeDiv(CURSOR_X, over);
		if (cursor.y) yCursor = placeDiv(CURSOR_Y, over);
		if (scaleX.ori == 0) {
			vCursor = xCursor;
			hCursor = yCursor;
		} else {
			vCursor = yCursor;
			hCursor = xCursor;
		}
		mouseLeft1 = cursor.left;
		mouseTop1 = cursor.top;
	}
	const select = self.select = assign({
		show: true,
		over: true,
		left: 0,
		width: 0,
		top: 0,
		height: 0
	}, opts.select);
	const selectDiv = select.show ? placeDiv(SELECT, select.over ? over : under) : null;
	function setSelect(opts, _fire) {
		if (select.show) {
			for (let prop in opts) {
				select[prop] = opts[prop];
				if (prop in _hideProps) setStylePx(selectDiv, prop, opts[prop]);
			}
			_fire !== false && fire("setSelect");
		}
	}
	self.setSelect = setSelect;
	function toggleDOM(i) {
		if (series[i].show) showLegend && remClass(legendRows[i], OFF);
		else {
			showLegend && addClass(legendRows[i], OFF);
			if (showCursor) {
				let pt = cursorOnePt ? cursorPts[0] : cursorPts[i];
				pt != null && elTrans(pt, -10, -10, plotWidCss, plotHgtCss);
			}
		}
	}
	function _setScale(key, min, max) {
		setScale(key, {
			min,
			max
		});
	}
	function setSeries(i, opts, _fire, _pub) {
		if (opts.focus != null) setFocus(i);
		if (opts.show != null) series.forEach((s, si) => {
			if (si > 0 && (i == si || i == null)) {
				s.show = opts.show;
				toggleDOM(si);
				if (mode == 2) {
					_setScale(s.facets[0].scale, null, null);
					_setScale(s.facets[1].scale, null, null);
				} else _setScale(s.scale, null, null);
				commit();
			}
		});
		_fire !== false && fire("setSeries", i, opts);
		_pub && pubSync("setSeries", self, i, opts);
	}
	self.setSeries = setSeries;
	function setBand(bi, opts) {
		assign(bands[bi], opts);
	}
	function addBand(opts, bi) {
		opts.fill = fnOrSelf(opts.fill || null);
		opts.dir = ifNull(opts.dir, -1);
		bi = bi == null ? bands.length : bi;
		bands.splice(bi, 0, opts);
	}
	function delBand(bi) {
		if (bi == null) bands.length = 0;
		else bands.splice(bi, 1);
	}
	self.addBand = addBand;
	self.setBand = setBand;
	self.delBand = delBand;
	function setAlpha(i, value) {
		series[i].alpha = value;
		if (showCursor && cursorPts[i] != null) cursorPts[i].style.opacity = value;
		if (showLegend && legendRows[i]) legendRows[i].style.opacity = value;
	}
	let closestDist;
	let closestSeries;
	let focusedSeries;
	const FOCUS_TRUE = { focus: true };
	function setFocus(i) {
		if (i != focusedSeries) {
			let allFocused = i == null;
			let _setAlpha = focus.alpha != 1;
			series.forEach((s, i2) => {
				if (mode == 1 || i2 > 0) {
					let isFocused = allFocused || i2 == 0 || i2 == i;
					s._focus = allFocused ? null : isFocused;
					_setAlpha && setAlpha(i2, isFocused ? 1 : focus.alpha);
				}
			});
			focusedSeries = i;
			_setAlpha && commit();
		}
	}
	if (showLegend && cursorFocus) onMouse(mouseleave, legendTable, (e) => {
		if (cursor._lock) return;
		setCursorEvent(e);
		if (focusedSeries != null) setSeries(null, FOCUS_TRUE, true, syncOpts.setSeries);
	});
	function posToVal(pos, scale, can) {
		let sc = scales[scale];
		if (can) pos = pos / pxRatio - (sc.ori == 1 ? plotTopCss : plotLftCss);
		let dim = plotWidCss;
		if (sc.ori == 1) {
			dim = plotHgtCss;
			pos = dim - pos;
		}
		if (sc.dir == -1) pos = dim - pos;
		let _min = sc._min, _max = sc._max, pct = pos / dim;
		let sv = _min + (_max - _min) * pct;
		let distr = sc.distr;
		return distr == 3 ? pow(10, sv) : distr == 4 ? sinh(sv, sc.asinh) : distr == 100 ? sc.bwd(sv) : sv;
	}
	function closestIdxFromXpos(pos, can) {
		return closestIdx(posToVal(pos, xScaleKey, can), data[0], i0, i1);
	}
	self.valToIdx = (val) => closestIdx(val, data[0]);
	self.posToIdx = closestIdxFromXpos;
	self.posToVal = posToVal;
	self.valToPos = (val, scale, can) => scales[scale].ori == 0 ? getHPos(val, scales[scale], can ? plotWid : plotWidCss, can ? plotLft : 0) : getVPos(val, scales[scale], can ? plotHgt : plotHgtCss, can ? plotTop : 0);
	self.setCursor = (opts, _fire, _pub) => {
		mouseLeft1 = opts.left;
		mouseTop1 = opts.top;
		updateCursor(null, _fire, _pub);
	};
	function setSelH(off, dim) {
		setStylePx(selectDiv, LEFT, select.left = off);
		setStylePx(selectDiv, WIDTH, select.width = dim);
	}
	function setSelV(off, dim) {
		setStylePx(selectDiv, TOP, select.top = off);
		setStylePx(selectDiv, HEIGHT$2, select.height = dim);
	}
	let setSelX = scaleX.ori == 0 ? setSelH : setSelV;
	let setSelY = scaleX.ori == 1 ? setSelH : setSelV;
	function syncLegend() {
		if (showLegend && legend.live) for (let i = mode == 2 ? 1 : 0; i < series.length; i++) {
			if (i == 0 && multiValLegend) continue;
			let vals = legend.values[i];
			let j = 0;
			for (let k in vals) legendCells[i][j++].firstChild.nodeValue = vals[k];
		}
	}
	function setLegend(opts, _fire) {
		if (opts != null) {
			if (opts.idxs) opts.idxs.forEach((didx, sidx) => {
				activeIdxs[sidx] = didx;
			});
			else if (!isUndef(opts.idx)) activeIdxs.fill(opts.idx);
			legend.idx = activeIdxs[0];
		}
		if (showLegend && legend.live) {
			for (let sidx = 0; sidx < series.length; sidx++) if (sidx > 0 || mode == 1 && !multiValLegend) setLegendValues(sidx, activeIdxs[sidx]);
			syncLegend();
		}
		shouldSetLegend = false;
		_fire !== false && fire("setLegend");
	}
	self.setLegend = setLegend;
	function setLegendValues(sidx, idx) {
		let s = series[sidx];
		let src = sidx == 0 && xScaleDistr == 2 ? data0 : data[sidx];
		let val;
		if (multiValLegend) val = s.values(self, sidx, idx) ?? NULL_LEGEND_VALUES;
		else {
			val = s.value(self, idx == null ? null : src[idx], sidx, idx);
			val = val == null ? NULL_LEGEND_VALUES : { _: val };
		}
		legend.values[sidx] = val;
	}
	function updateCursor(src, _fire, _pub) {
		rawMouseLeft1 = mouseLeft1;
		rawMouseTop1 = mouseTop1;
		[mouseLeft1, mouseTop1] = cursor.move(self, mouseLeft1, mouseTop1);
		cursor.left = mouseLeft1;
		cursor.top = mouseTop1;
		if (showCursor) {
			vCursor && elTrans(vCursor, round$1(mouseLeft1), 0, plotWidCss, plotHgtCss);
			hCursor && elTrans(hCursor, 0, round$1(mouseTop1), plotWidCss, plotHgtCss);
		}
		let idx;
		let noDataInRange = i0 > i1;
		closestDist = inf;
		closestSeries = null;
		let xDim = scaleX.ori == 0 ? plotWidCss : plotHgtCss;
		let yDim = scaleX.ori == 1 ? plotWidCss : plotHgtCss;
		if (mouseLeft1 < 0 || dataLen == 0 || noDataInRange) {
			idx = cursor.idx = null;
			for (let i = 0; i < series.length; i++) {
				let pt = cursorPts[i];
				pt != null && elTrans(pt, -10, -10, plotWidCss, plotHgtCss);
			}
			if (cursorFocus) setSeries(null, FOCUS_TRUE, true, src == null && syncOpts.setSeries);
			if (legend.live) {
				activeIdxs.fill(idx);
				shouldSetLegend = true;
			}
		} else {
			let mouseXPos, valAtPosX, xPos;
			if (mode == 1) {
				mouseXPos = scaleX.ori == 0 ? mouseLeft1 : mouseTop1;
				valAtPosX = posToVal(mouseXPos, xScaleKey);
				idx = cursor.idx = closestIdx(valAtPosX, data[0], i0, i1);
				xPos = valToPosX(data[0][idx], scaleX, xDim, 0);
			}
			let _ptLft = -10;
			let _ptTop = -10;
			let _ptWid = 0;
			let _ptHgt = 0;
			let _centered = true;
			let _ptFill = "";
			let _ptStroke = "";
			for (let i = mode == 2 ? 1 : 0; i < series.length; i++) {
				let s = series[i];
				let idx1 = activeIdxs[i];
				let yVal1 = idx1 == null ? null : mode == 1 ? data[i][idx1] : data[i][1][idx1];
				let idx2 = cursor.dataIdx(self, i, idx, valAtPosX);
				let yVal2 = idx2 == null ? null : mode == 1 ? data[i][idx2] : data[i][1][idx2];
				shouldSetLegend = shouldSetLegend || yVal2 != yVal1 || idx2 != idx1;
				activeIdxs[i] = idx2;
				if (i > 0 && s.show) {
					let xPos2 = idx2 == null ? -10 : idx2 == idx ? xPos : valToPosX(mode == 1 ? data[0][idx2] : data[i][0][idx2], scaleX, xDim, 0);
					let yPos = yVal2 == null ? -10 : valToPosY(yVal2, mode == 1 ? scales[s.scale] : scales[s.facets[1].scale], yDim, 0);
					if (cursorFocus && yVal2 != null) {
						let mouseYPos = scaleX.ori == 1 ? mouseLeft1 : mouseTop1;
						let dist = abs(focus.dist(self, i, idx2, yPos, mouseYPos));
						if (dist < closestDist) {
							let bias = focus.bias;
							if (bias != 0) {
								let mouseYVal = posToVal(mouseYPos, s.scale);
								let seriesYValSign = yVal2 >= 0 ? 1 : -1;
								let mouseYValSign = mouseYVal >= 0 ? 1 : -1;
								if (mouseYValSign == seriesYValSign && (mouseYValSign == 1 ? bias == 1 ? yVal2 >= mouseYVal : yVal2 <= mouseYVal : bias == 1 ? yVal2 <= mouseYVal : yVal2 >= mouseYVal)) {
									closestDist = dist;
									closestSeries = i;
								}
							} else {
								closestDist = dist;
								closestSeries = i;
							}
						}
					}
					if (shouldSetLegend || cursorOnePt) {
						let hPos, vPos;
						if (scaleX.ori == 0) {
							hPos = xPos2;
							vPos = yPos;
						} else {
							hPos = yPos;
							vPos = xPos2;
						}
						let ptWid, ptHgt, ptLft, ptTop, ptStroke, ptFill, centered = true, getBBox = points.bbox;
						if (getBBox != null) {
							centered = false;
							let bbox = getBBox(self, i);
							ptLft = bbox.left;
							ptTop = bbox.top;
							ptWid = bbox.width;
							ptHgt = bbox.height;
						} else {
							ptLft = hPos;
							ptTop = vPos;
							ptWid = ptHgt = points.size(self, i);
						}
						ptFill = points.fill(self, i);
						ptStroke = points.stroke(self, i);
						if (cursorOnePt) {
							if (i == closestSeries && closestDist <= focus.prox) {
								_ptLft = ptLft;
								_ptTop = ptTop;
								_ptWid = ptWid;
								_ptHgt = ptHgt;
								_centered = centered;
								_ptFill = ptFill;
								_ptStroke = ptStroke;
							}
						} else {
							let pt = cursorPts[i];
							if (pt != null) {
								cursorPtsLft[i] = ptLft;
								cursorPtsTop[i] = ptTop;
								elSize(pt, ptWid, ptHgt, centered);
								elColor(pt, ptFill, ptStroke);
								elTrans(pt, ceil(ptLft), ceil(ptTop), plotWidCss, plotHgtCss);
							}
						}
					}
				}
			}
			if (cursorOnePt) {
				let p = focus.prox;
				if (shouldSetLegend || (focusedSeries == null ? closestDist <= p : closestDist > p || closestSeries != focusedSeries)) {
					let pt = cursorPts[0];
					if (pt != null) {
						cursorPtsLft[0] = _ptLft;
						cursorPtsTop[0] = _ptTop;
						elSize(pt, _ptWid, _ptHgt, _centered);
						elColor(pt, _ptFill, _ptStroke);
						elTrans(pt, ceil(_ptLft), ceil(_ptTop), plotWidCss, plotHgtCss);
					}
				}
			}
		}
		if (select.show && dragging) {
			if (src != null) {
				let [xKey, yKey] = syncOpts.scales;
				let [matchXKeys, matchYKeys] = syncOpts.match;
				let [xKeySrc, yKeySrc] = src.cursor.sync.scales;
				let sdrag = src.cursor.drag;
				dragX = sdrag._x;
				dragY = sdrag._y;
				if (dragX || dragY) {
					let { left, top, width, height } = src.select;
					let sori = src.scales[xKeySrc].ori;
					let sPosToVal = src.posToVal;
					let sOff, sDim, sc, a, b;
					let matchingX = xKey != null && matchXKeys(xKey, xKeySrc);
					let matchingY = yKey != null && matchYKeys(yKey, yKeySrc);
					if (matchingX && dragX) {
						if (sori == 0) {
							sOff = left;
							sDim = width;
						} else {
							sOff = top;
							sDim = height;
						}
						sc = scales[xKey];
						a = valToPosX(sPosToVal(sOff, xKeySrc), sc, xDim, 0);
						b = valToPosX(sPosToVal(sOff + sDim, xKeySrc), sc, xDim, 0);
						setSelX(min(a, b), abs(b - a));
					} else setSelX(0, xDim);
					if (matchingY && dragY) {
						if (sori == 1) {
							sOff = left;
							sDim = width;
						} else {
							sOff = top;
							sDim = height;
						}
						sc = scales[yKey];
						a = valToPosY(sPosToVal(sOff, yKeySrc), sc, yDim, 0);
						b = valToPosY(sPosToVal(sOff + sDim, yKeySrc), sc, yDim, 0);
						setSelY(min(a, b), abs(b - a));
					} else setSelY(0, yDim);
				} else hideSelect();
			} else {
				let rawDX = abs(rawMouseLeft1 - rawMouseLeft0);
				let rawDY = abs(rawMouseTop1 - rawMouseTop0);
				if (scaleX.ori == 1) {
					let _rawDX = rawDX;
					rawDX = rawDY;
					rawDY = _rawDX;
				}
				dragX = drag.x && rawDX >= drag.dist;
				dragY = drag.y && rawDY >= drag.dist;
				let uni = drag.uni;
				if (uni != null) {
					if (dragX && dragY) {
						dragX = rawDX >= uni;
						dragY = rawDY >= uni;
						if (!dragX && !dragY) {
							if (rawDY > rawDX) dragY = true;
							else dragX = true;
						}
					}
				} else if (drag.x && drag.y && (dragX || dragY)) dragX = dragY = true;
				let p0, p1;
				if (dragX) {
					if (scaleX.ori == 0) {
						p0 = mouseLeft0;
						p1 = mouseLeft1;
					} else {
						p0 = mouseTop0;
						p1 = mouseTop1;
					}
					setSelX(min(p0, p1), abs(p1 - p0));
					if (!dragY) setSelY(0, yDim);
				}
				if (dragY) {
					if (scaleX.ori == 1) {
						p0 = mouseLeft0;
						p1 = mouseLeft1;
					} else {
						p0 = mouseTop0;
						p1 = mouseTop1;
					}
					setSelY(min(p0, p1), abs(p1 - p0));
					if (!dragX) setSelX(0, xDim);
				}
				if (!dragX && !dragY) {
					setSelX(0, 0);
					setSelY(0, 0);
				}
			}
		}
		drag._x = dragX;
		drag._y = dragY;
		if (src == null) {
			if (_pub) {
				if (syncKey != null) {
					let [xSyncKey, ySyncKey] = syncOpts.scales;
					syncOpts.values[0] = xSyncKey != null ? posToVal(scaleX.ori == 0 ? mouseLeft1 : mouseTop1, xSyncKey) : null;
					syncOpts.values[1] = ySyncKey != null ? posToVal(scaleX.ori == 1 ? mouseLeft1 : mouseTop1, ySyncKey) : null;
				}
				pubSync(mousemove, self, mouseLeft1, mouseTop1, plotWidCss, plotHgtCss, idx);
			}
			if (cursorFocus) {
				let shouldPub = _pub && syncOpts.setSeries;
				let p = focus.prox;
				if (focusedSeries == null) {
					if (closestDist <= p) setSeries(closestSeries, FOCUS_TRUE, true, shouldPub);
				} else if (closestDist > p) setSeries(null, FOCUS_TRUE, true, shouldPub);
				else if (closestSeries != focusedSeries) setSeries(closestSeries, FOCUS_TRUE, true, shouldPub);
			}
		}
		if (shouldSetLegend) {
			legend.idx = idx;
			setLegend();
		}
		_fire !== false && fire("setCursor");
	}
	let rect = null;
	Object.defineProperty(self, "rect", { get() {
		if (rect == null) syncRect(false);
		return rect;
	} });
	function syncRect(defer = false) {
		if (defer) rect = null;
		else {
			rect = over.getBoundingClientRect();
			fire("syncRect", rect);
		}
	}
	function mouseMove(e, src, _l, _t, _w, _h, _i) {
		if (cursor._lock) return;
		if (dragging && e != null && e.movementX == 0 && e.movementY == 0) return;
		cacheMouse(e, src, _l, _t, _w, _h, _i, false, e != null);
		if (e != null) updateCursor(null, true, true);
		else updateCursor(src, true, false);
	}
	function cacheMouse(e, src, _l, _t, _w, _h, _i, initial, snap) {
		if (rect == null) syncRect(false);
		setCursorEvent(e);
		if (e != null) {
			_l = e.clientX - rect.left;
			_t = e.clientY - rect.top;
		} else {
			if (_l < 0 || _t < 0) {
				mouseLeft1 = -10;
				mouseTop1 = -10;
				return;
			}
			let [xKey, yKey] = syncOpts.scales;
			let syncOptsSrc = src.cursor.sync;
			let [xValSrc, yValSrc] = syncOptsSrc.values;
			let [xKeySrc, yKeySrc] = syncOptsSrc.scales;
			let [matchXKeys, matchYKeys] = syncOpts.match;
			let rotSrc = src.axes[0].side % 2 == 1;
			let xDim = scaleX.ori == 0 ? plotWidCss : plotHgtCss, yDim = scaleX.ori == 1 ? plotWidCss : plotHgtCss, _xDim = rotSrc ? _h : _w, _yDim = rotSrc ? _w : _h, _xPos = rotSrc ? _t : _l, _yPos = rotSrc ? _l : _t;
			if (xKeySrc != null) _l = matchXKeys(xKey, xKeySrc) ? getPos(xValSrc, scales[xKey], xDim, 0) : -10;
			else _l = xDim * (_xPos / _xDim);
			if (yKeySrc != null) _t = matchYKeys(yKey, yKeySrc) ? getPos(yValSrc, scales[yKey], yDim, 0) : -10;
			else _t = yDim * (_yPos / _yDim);
			if (scaleX.ori == 1) {
				let __l = _l;
				_l = _t;
				_t = __l;
			}
		}
		if (snap && (src == null || src.cursor.event.type == mousemove)) {
			if (_l <= 1 || _l >= plotWidCss - 1) _l = incrRound(_l, plotWidCss);
			if (_t <= 1 || _t >= plotHgtCss - 1) _t = incrRound(_t, plotHgtCss);
		}
		if (initial) {
			rawMouseLeft0 = _l;
			rawMouseTop0 = _t;
			[mouseLeft0, mouseTop0] = cursor.move(self, _l, _t);
		} else {
			mouseLeft1 = _l;
			mouseTop1 = _t;
		}
	}
	const _hideProps = {
		width: 0,
		height: 0,
		left: 0,
		top: 0
	};
	function hideSelect() {
		setSelect(_hideProps, false);
	}
	let downSelectLeft;
	let downSelectTop;
	let downSelectWidth;
	let downSelectHeight;
	function mouseDown(e, src, _l, _t, _w, _h, _i) {
		dragging = true;
		dragX = dragY = drag._x = drag._y = false;
		cacheMouse(e, src, _l, _t, _w, _h, _i, true, false);
		if (e != null) {
			onMouse(mouseup, doc, mouseUp, false);
			pubSync(mousedown, self, mouseLeft0, mouseTop0, plotWidCss, plotHgtCss, null);
		}
		let { left, top, width, height } = select;
		downSelectLeft = left;
		downSelectTop = top;
		downSelectWidth = width;
		downSelectHeight = height;
	}
	function mouseUp(e, src, _l, _t, _w, _h, _i) {
		dragging = drag._x = drag._y = false;
		cacheMouse(e, src, _l, _t, _w, _h, _i, false, true);
		let { left, top, width, height } = select;
		let hasSelect = width > 0 || height > 0;
		let chgSelect = downSelectLeft != left || downSelectTop != top || downSelectWidth != width || downSelectHeight != height;
		hasSelect && chgSelect && setSelect(select);
		if (drag.setScale && hasSelect && chgSelect) {
			let xOff = left, xDim = width, yOff = top, yDim = height;
			if (scaleX.ori == 1) xOff = top, xDim = height, yOff = left, yDim = width;
			if (dragX) _setScale(xScaleKey, posToVal(xOff, xScaleKey), posToVal(xOff + xDim, xScaleKey));
			if (dragY) for (let k in scales) {
				let sc = scales[k];
				if (k != xScaleKey && sc.from == null && sc.min != inf) _setScale(k, posToVal(yOff + yDim, k), posToVal(yOff, k));
			}
			hideSelect();
		} else if (cursor.lock) {
			cursor._lock = !cursor._lock;
			updateCursor(src, true, e != null);
		}
		if (e != null) {
			offMouse(mouseup, doc);
			pubSync(mouseup, self, mouseLeft1, mouseTop1, plotWidCss, plotHgtCss, null);
		}
	}
	function mouseLeave(e, src, _l, _t, _w, _h, _i) {
		if (cursor._lock) return;
		setCursorEvent(e);
		let _dragging = dragging;
		if (dragging) {
			let snapH = true;
			let snapV = true;
			let snapProx = 10;
			let dragH, dragV;
			if (scaleX.ori == 0) {
				dragH = dragX;
				dragV = dragY;
			} else {
				dragH = dragY;
				dragV = dragX;
			}
			if (dragH && dragV) {
				snapH = mouseLeft1 <= snapProx || mouseLeft1 >= plotWidCss - snapProx;
				snapV = mouseTop1 <= snapProx || mouseTop1 >= plotHgtCss - snapProx;
			}
			if (dragH && snapH) mouseLeft1 = mouseLeft1 < mouseLeft0 ? 0 : plotWidCss;
			if (dragV && snapV) mouseTop1 = mouseTop1 < mouseTop0 ? 0 : plotHgtCss;
			updateCursor(null, true, true);
			dragging = false;
		}
		mouseLeft1 = -10;
		mouseTop1 = -10;
		activeIdxs.fill(null);
		updateCursor(null, true, true);
		if (_dragging) dragging = _dragging;
	}
	function dblClick(e, src, _l, _t, _w, _h, _i) {
		if (cursor._lock) return;
		setCursorEvent(e);
		autoScaleX();
		hideSelect();
		if (e != null) pubSync(dblclick, self, mouseLeft1, mouseTop1, plotWidCss, plotHgtCss, null);
	}
	function syncPxRatio() {
		axes.forEach(syncFontSize);
		_setSize(self.width, self.height, true);
	}
	on(dppxchange, win, syncPxRatio);
	const events = {};
	events.mousedown = mouseDown;
	events.mousemove = mouseMove;
	events.mouseup = mouseUp;
	events.dblclick = dblClick;
	events["setSeries"] = (e, src, idx, opts) => {
		let seriesIdxMatcher = syncOpts.match[2];
		idx = seriesIdxMatcher(self, src, idx);
		idx != -1 && setSeries(idx, opts, true, false);
	};
	if (showCursor) {
		onMouse(mousedown, over, mouseDown);
		onMouse(mousemove, over, mouseMove);
		onMouse(mouseenter, over, (e) => {
			setCursorEvent(e);
			syncRect(false);
		});
		onMouse(mouseleave, over, mouseLeave);
		onMouse(dblclick, over, dblClick);
		cursorPlots.add(self);
		self.syncRect = syncRect;
	}
	const hooks = self.hooks = opts.hooks || {};
	function fire(evName, a1, a2) {
		if (deferHooks) hooksQueue.push([
			evName,
			a1,
			a2
		]);
		else if (evName in hooks) hooks[evName].forEach((fn) => {
			fn.call(null, self, a1, a2);
		});
	}
	(opts.plugins || []).forEach((p) => {
		for (let evName in p.hooks) hooks[evName] = (hooks[evName] || []).concat(p.hooks[evName]);
	});
	const seriesIdxMatcher = (self, src, srcSeriesIdx) => srcSeriesIdx;
	const syncOpts = assign({
		key: null,
		setSeries: false,
		filters: {
			pub: retTrue,
			sub: retTrue
		},
		scales: [xScaleKey, series[1] ? series[1].scale : null],
		match: [
			retEq,
			retEq,
			seriesIdxMatcher
		],
		values: [null, null]
	}, cursor.sync);
	if (syncOpts.match.length == 2) syncOpts.match.push(seriesIdxMatcher);
	cursor.sync = syncOpts;
	const syncKey = syncOpts.key;
	const sync = _sync(syncKey);
	function pubSync(type, src, x, y, w, h, i) {
		if (syncOpts.filters.pub(type, src, x, y, w, h, i)) sync.pub(type, src, x, y, w, h, i);
	}
	sync.sub(self);
	function pub(type, src, x, y, w, h, i) {
		if (syncOpts.filters.sub(type, src, x, y, w, h, i)) events[type](null, src, x, y, w, h, i);
	}
	self.pub = pub;
	function destroy() {
		sync.unsub(self);
		cursorPlots.delete(self);
		mouseListeners.clear();
		off(dppxchange, win, syncPxRatio);
		root.remove();
		legendTable?.remove();
		fire("destroy");
	}
	self.destroy = destroy;
	function _init() {
		fire("init", opts, data);
		setData(data || opts.data, false);
		if (pendScales[xScaleKey]) setScale(xScaleKey, pendScales[xScaleKey]);
		else autoScaleX();
		shouldSetSelect = select.show && (select.width > 0 || select.height > 0);
		shouldSetCursor = shouldSetLegend = true;
		_setSize(opts.width, opts.height);
	}
	series.forEach(initSeries);
	axes.forEach(initAxis);
	if (then) {
		if (then instanceof HTMLElement) {
			then.appendChild(root);
			_init();
		} else then(self, _init);
	} else _init();
	return self;
}
uPlot.assign = assign;
uPlot.fmtNum = fmtNum;
uPlot.rangeNum = rangeNum;
uPlot.rangeLog = rangeLog;
uPlot.rangeAsinh = rangeAsinh;
uPlot.orient = orient;
uPlot.pxRatio = pxRatio;
uPlot.join = join;
uPlot.fmtDate = fmtDate;
uPlot.tzDate = tzDate;
uPlot.sync = _sync;
{
	uPlot.addGap = addGap;
	uPlot.clipGaps = clipGaps;
	let paths = uPlot.paths = { points };
	paths.linear = linear;
	paths.stepped = stepped$1;
	paths.bars = bars;
	paths.spline = monotoneCubic;
}
// src/theme.ts
/** Light or dark: the colours themselves are custom properties of the style sheet, which the map reads too. */
var KEPT$1 = "hoistway.theme";
var kept$2 = localStorage.getItem(KEPT$1);
var LIGHT = matchMedia("(prefers-color-scheme: light)");
var theme = y$1(kept$2 === "dark" || kept$2 === "light" ? kept$2 : LIGHT.matches ? "light" : "dark");
/** Show it, without choosing it for good. */
function wear(next) {
	document.documentElement.dataset["theme"] = next;
	theme.value = next;
}
function choose$1(next) {
	localStorage.setItem(KEPT$1, next);
	wear(next);
}
function begin$3() {
	wear(theme.value);
	LIGHT.addEventListener("change", () => {
		if (!localStorage.getItem(KEPT$1)) wear(LIGHT.matches ? "light" : "dark");
	});
}
// src/parts/LiveChart.tsx
/** A chart that grows at its right end: each unit has a scale of its own, the first two an axis. */
var HEIGHT$1 = 200;
var COLOURS$2 = [
	"--look-moving",
	"--look-held",
	"--look-charging",
	"--look-handling",
	"--look-waiting",
	"--look-alarm"
];
var timeOf = (seconds) => clock((/* @__PURE__ */ new Date(seconds * 1e3)).toISOString());
/** `times` in seconds since 1970. It is drawn anew only when other lines are wanted. */
function LiveChart({ label, times, lines }) {
	const box = T(null);
	const chart = T(null);
	const what = lines.map((line) => `${line.label} ${line.unit}`).join("\n");
	const wears = theme.value;
	A$1(() => {
		const parent = box.current;
		const style = getComputedStyle(document.documentElement);
		const of = (name) => style.getPropertyValue(name).trim();
		const units = [...new Set(lines.map(({ unit }) => unit))];
		const axis = {
			stroke: of("--dim"),
			grid: {
				stroke: of("--line"),
				width: 1
			},
			ticks: {
				stroke: of("--line"),
				width: 1
			}
		};
		const made = new uPlot({
			width: parent.clientWidth,
			height: HEIGHT$1,
			series: [{
				label: t("when"),
				value: (_, at) => at === null ? "–" : timeOf(at)
			}, ...lines.map(({ label: name, unit }, i) => ({
				label: unit ? `${name} (${unit})` : name,
				scale: `of ${unit}`,
				stroke: of(COLOURS$2[i % COLOURS$2.length]),
				width: 2,
				spanGaps: true
			}))],
			axes: [{
				...axis,
				space: 80,
				values: (_, at) => at.map(timeOf)
			}, ...units.slice(0, 2).map((unit, i) => ({
				...axis,
				scale: `of ${unit}`,
				side: i ? 1 : 3,
				grid: i ? { show: false } : axis.grid,
				...unit ? {
					label: unit,
					labelSize: 16
				} : {}
			}))]
		}, [times, ...lines.map(({ values }) => values)], parent);
		chart.current = made;
		const size = new ResizeObserver(() => made.setSize({
			width: parent.clientWidth,
			height: HEIGHT$1
		}));
		size.observe(parent);
		return () => {
			size.disconnect();
			made.destroy();
			chart.current = null;
		};
	}, [wears, what]);
	A$1(() => {
		const now = chart.current;
		now?.setData([times, ...lines.map(({ values }) => values)]);
		if (now && (now.cursor.left ?? -1) < 0) now.setLegend({ idx: times.length - 1 });
	}, [times, lines]);
	return /* @__PURE__ */ a("figure", {
		class: "chart",
		children: [/* @__PURE__ */ a("figcaption", { children: label }), /* @__PURE__ */ a("div", {
			ref: box,
			role: "img",
			"aria-label": label,
			"data-points": times.length
		})]
	});
}
// src/parts/DriveWatch.tsx
/** Parameters of a drive watched live: polled by the server as long as somebody looks, and drawn over the last minutes. */
/** Asked so often, ms; the server is told again in time that somebody still looks, s. */
var EVERY$5 = 500;
var GOOD_FOR = 20;
var AGAIN$1 = 8;
/** So much is shown, s, and at most so many lines. */
var SPAN = 180;
var MOST$3 = 6;
/** One name for each page, so that two people may watch the same drive. */
var NAME = `page-${Math.random().toString(36).slice(2, 10)}`;
function DriveWatch({ path }) {
	const chosen = useSignal([]);
	const on = useSignal(false);
	const past = useSignal({
		times: [],
		values: {}
	});
	const error = useSignal(null);
	const { value } = useRead(`${path}/parameters`);
	const known = value?.items.filter(({ named, raw }) => named || raw !== null) ?? [];
	const numbers = chosen.value.join();
	const watch = `${path}/watches/${NAME}`;
	A$1(() => {
		if (!on.value || !numbers) return void 0;
		let here = true;
		const fail = (failure) => {
			error.value = failure;
			on.value = false;
		};
		const tell = () => void call("PUT", watch, {
			parameters: numbers.split(","),
			seconds: GOOD_FOR
		}).catch(fail);
		const look = async () => {
			try {
				const { items } = await get(`${path}/parameters`);
				if (here) past.value = grown$1(past.value, numbers.split(","), items);
			} catch (failure) {
				if (here) fail(failure);
			}
		};
		error.value = null;
		past.value = {
			times: [],
			values: {}
		};
		tell();
		const timers = [window.setInterval(tell, AGAIN$1 * 1e3), window.setInterval(() => void look(), EVERY$5)];
		return () => {
			here = false;
			timers.forEach(window.clearInterval);
			call("DELETE", watch).catch(() => void 0);
		};
	}, [
		path,
		numbers,
		on.value
	]);
	const turn = (number, wanted) => {
		chosen.value = known.map((one) => one.number).filter((one) => one === number ? wanted : chosen.value.includes(one));
	};
	const lines = chosen.value.flatMap((number) => {
		const parameter = known.find((one) => one.number === number);
		return parameter ? [{
			label: tell(parameter.name) || number,
			unit: parameter.unit,
			values: past.value.values[number] ?? []
		}] : [];
	});
	return /* @__PURE__ */ a("details", {
		class: "part acts",
		children: [/* @__PURE__ */ a("summary", { children: t("watch") }), /* @__PURE__ */ a("div", {
			class: "stack",
			"data-watch": true,
			children: [
				/* @__PURE__ */ a("fieldset", {
					class: "roles watched",
					children: [
						/* @__PURE__ */ a("legend", { children: t("parameters") }),
						known.map(({ number, name }) => /* @__PURE__ */ a("label", { children: [
							/* @__PURE__ */ a("input", {
								type: "checkbox",
								checked: chosen.value.includes(number),
								disabled: !chosen.value.includes(number) && chosen.value.length >= MOST$3,
								onChange: (event) => turn(number, event.currentTarget.checked)
							}),
							" ",
							number,
							" ",
							tell(name)
						] }, number)),
						known.length === 0 && /* @__PURE__ */ a("span", {
							class: "calm",
							children: t("no_parameters")
						})
					]
				}),
				/* @__PURE__ */ a("div", {
					class: "acts-row",
					children: [/* @__PURE__ */ a(Button, {
						needs: "PUT /drives/{drive}/watches/{watch}",
						"aria-pressed": on.value,
						disabled: chosen.value.length === 0,
						onClick: () => on.value = !on.value,
						children: t(on.value ? "watch_end" : "watch_begin")
					}), refusal("PUT /drives/{drive}/watches/{watch}") === "" && /* @__PURE__ */ a("small", {
						class: "calm",
						children: t("watch_hint", MOST$3)
					})]
				}),
				/* @__PURE__ */ a(Problem, { error: error.value }),
				past.value.times.length > 0 && /* @__PURE__ */ a(LiveChart, {
					label: t("watch"),
					times: past.value.times,
					lines
				})
			]
		})]
	});
}
/** With one more moment at the end, and what is too old gone from the beginning. */
function grown$1(past, numbers, items) {
	const now = serverNow() / 1e3;
	const first = past.times.findIndex((at) => at > now - SPAN);
	const from = first < 0 ? past.times.length : first;
	const valueOf = (number) => {
		const parameter = items.find((one) => one.number === number);
		return parameter ? parameter.value ?? parameter.raw : null;
	};
	const values = numbers.map((number) => [number, [...(past.values[number] ?? []).slice(from), valueOf(number)]]);
	return {
		times: [...past.times.slice(from), now],
		values: Object.fromEntries(values)
	};
}
// src/parts/DriveTools.tsx
/** What can be done to a drive: jog, write a parameter, back up, compare, restore; each an operation that ends in one known way. */
function DriveTools({ drive }) {
	const path = `/drives/${encodeURIComponent(drive.id)}`;
	return /* @__PURE__ */ a($, { children: [
		/* @__PURE__ */ a(Jog, {
			drive,
			path
		}),
		/* @__PURE__ */ a(DriveWatch, { path }),
		/* @__PURE__ */ a(Backups, {
			drive,
			path
		}),
		/* @__PURE__ */ a(DriveCatalogue, { path }),
		/* @__PURE__ */ a(DriveMore, {
			drive,
			path
		}),
		/* @__PURE__ */ a("details", {
			class: "part acts",
			children: [/* @__PURE__ */ a("summary", { children: t("lockout") }), /* @__PURE__ */ a(Reasoned, { decisions: [drive.lockout ? {
				label: t("lift_lockout"),
				needs: "DELETE /drives/{drive}/lockout",
				bare: true,
				grave: true,
				does: () => call("DELETE", `${path}/lockout`)
			} : {
				label: t("lock_out"),
				needs: "POST /drives/{drive}/lockout",
				grave: true,
				does: (reason) => post(`${path}/lockout`, { reason })
			}] })]
		})
	] });
}
/** The key is said to be held so often, ms; the axis stops by itself when it is not. */
var HELD = 200;
/** Runs as long as the button is held: let go, hidden or left, it is released. It is not disabled while held: it would not be told. */
function Jog({ drive, path }) {
	const asking = useAsking();
	const way = useSignal(null);
	const held = T(null);
	const release = () => {
		const now = held.current;
		held.current = null;
		way.value = null;
		if (!now) return;
		window.clearInterval(now.timer);
		if (now.jog !== null) asking.ask(() => call("DELETE", `${path}/jog/${now.jog}`), "");
	};
	A$1(() => {
		window.addEventListener("blur", release);
		document.addEventListener("visibilitychange", release);
		return () => {
			window.removeEventListener("blur", release);
			document.removeEventListener("visibilitychange", release);
			release();
		};
	}, [path]);
	const press = async (direction) => {
		if (held.current) return;
		const mine = {
			jog: null,
			timer: 0
		};
		held.current = mine;
		way.value = direction;
		await asking.ask(async () => {
			const { jog } = await post(`${path}/jog`, { direction });
			mine.jog = jog;
			if (held.current !== mine) {
				await call("DELETE", `${path}/jog/${jog}`);
				return;
			}
			mine.timer = window.setInterval(() => void post(`${path}/jog/${jog}`).catch(release), HELD);
		}, "");
		if (asking.error.value) release();
	};
	return /* @__PURE__ */ a("section", {
		class: "part",
		children: [
			/* @__PURE__ */ a("h3", { children: t("jog") }),
			/* @__PURE__ */ a("div", {
				class: "acts-row",
				children: [["ccw", "cw"].map((direction) => /* @__PURE__ */ a(Button, {
					needs: "POST /drives/{drive}/jog",
					class: "jog",
					"aria-pressed": way.value === direction,
					...way.value === null ? stopped(againstDrive(drive, "jog", around())) : {},
					onPointerDown: (event) => {
						event.currentTarget.setPointerCapture(event.pointerId);
						press(direction);
					},
					onPointerUp: release,
					onPointerCancel: release,
					onKeyDown: (event) => event.key === " " && !event.repeat && void press(direction),
					onKeyUp: (event) => event.key === " " && release(),
					children: [
						direction === "ccw" ? "◀ " : "",
						t(direction),
						direction === "cw" ? " ▶" : ""
					]
				}, direction)), /* @__PURE__ */ a("small", {
					class: "calm",
					children: t("jog_hint")
				})]
			}),
			/* @__PURE__ */ a(Told, { asking })
		]
	});
}
function Backups({ drive, path }) {
	const again = useSignal(0);
	const operation = useSignal(null);
	const label = useSignal("");
	const note = useSignal("");
	const other = useSignal("");
	const asking = useAsking();
	const { value } = useRead(`${path}/backups?limit=20`, again.value);
	const begin = (what, body, words) => {
		label.value = words;
		operation.value = null;
		asking.ask(async () => {
			let now = await post(`${path}/${what}`, body);
			operation.value = now;
			while (now.state === "running") {
				now = await get(`/operations/${encodeURIComponent(now.id)}?wait=2`);
				operation.value = now;
			}
			again.value++;
		}, "");
	};
	const differences = operation.value?.result["differences"] ?? operation.value?.result["rows"];
	const reading = stopped(againstDrive(drive, "read", around()));
	const others = driveList.value.filter(({ id }) => id !== drive.id);
	return /* @__PURE__ */ a("details", {
		class: "part acts",
		children: [/* @__PURE__ */ a("summary", { children: t("backups") }), /* @__PURE__ */ a("div", {
			class: "stack",
			children: [
				/* @__PURE__ */ a("div", {
					class: "fields",
					children: [/* @__PURE__ */ a(Field, {
						label: t("note"),
						value: note
					}), /* @__PURE__ */ a("div", {
						class: "acts-row",
						children: /* @__PURE__ */ a(Button, {
							needs: "POST /drives/{drive}/backups",
							onClick: () => begin("backups", { note: note.value.trim() }, t("back_up")),
							...reading,
							children: t("back_up")
						})
					})]
				}),
				others.length > 0 && /* @__PURE__ */ a("div", {
					class: "fields",
					children: [/* @__PURE__ */ a("label", { children: [/* @__PURE__ */ a("span", { children: t("compare_with") }), /* @__PURE__ */ a("select", {
						value: other.value,
						onChange: (event) => other.value = event.currentTarget.value,
						children: [/* @__PURE__ */ a("option", {
							value: "",
							children: t("choose")
						}), others.map(({ id }) => /* @__PURE__ */ a("option", { children: id }, id))]
					})] }), /* @__PURE__ */ a("div", {
						class: "acts-row",
						children: /* @__PURE__ */ a(Button, {
							needs: "POST /drives/{drive}/compare",
							disabled: !other.value,
							onClick: () => begin("compare", { drive: other.value }, t("compare")),
							...reading,
							children: t("compare")
						})
					})]
				}),
				value?.items.map((backup) => /* @__PURE__ */ a("div", {
					class: "acts-row",
					"data-backup": backup.id,
					children: [
						/* @__PURE__ */ a("span", { children: [
							"#",
							backup.id,
							" · ",
							clock(backup.at),
							" · ",
							backup.actor,
							" ",
							backup.note
						] }),
						/* @__PURE__ */ a(Button, {
							needs: "POST /drives/{drive}/compare",
							onClick: () => begin("compare", { backup: backup.id }, t("compare")),
							...reading,
							children: t("compare")
						}),
						/* @__PURE__ */ a(Button, {
							needs: "POST /drives/{drive}/restore",
							onClick: () => begin("restore", {
								backup: backup.id,
								dry_run: true
							}, t("restore_dry")),
							...stopped(againstDrive(drive, "change", around())),
							children: t("restore_dry")
						}),
						/* @__PURE__ */ a(Sure, {
							needs: "POST /drives/{drive}/restore",
							label: t("restore"),
							does: () => begin("restore", { backup: backup.id }, t("restore")),
							...stopped(againstDrive(drive, "write", around()))
						}),
						/* @__PURE__ */ a(BackupContents, { path: `${path}/backups/${backup.id}` })
					]
				}, backup.id)),
				/* @__PURE__ */ a(Told, { asking }),
				operation.value?.state === "running" && /* @__PURE__ */ a("small", { children: t("reading", operation.value.done, operation.value.total) }),
				/* @__PURE__ */ a(Outcome, {
					operation: operation.value,
					label: label.value
				}),
				Array.isArray(differences) && /* @__PURE__ */ a(Differences, { rows: differences })
			]
		})]
	});
}
function Differences({ rows }) {
	if (rows.length === 0) return /* @__PURE__ */ a("p", {
		class: "calm",
		children: t("no_differences")
	});
	const columns = [...new Set(rows.flatMap((row) => Object.keys(row)))];
	return /* @__PURE__ */ a("table", {
		class: "list",
		children: [/* @__PURE__ */ a("thead", { children: /* @__PURE__ */ a("tr", { children: columns.map((name) => /* @__PURE__ */ a("th", { children: /* @__PURE__ */ a("span", { children: name.replaceAll("_", " ") }) }, name)) }) }), /* @__PURE__ */ a("tbody", { children: rows.map((row, i) => /* @__PURE__ */ a("tr", { children: columns.map((name) => /* @__PURE__ */ a("td", { children: row[name] === null || row[name] === void 0 ? "–" : String(row[name]) }, name)) }, i)) })]
	});
}
// src/parts/DrivePanel.tsx
/** One axis drive: what it says of itself, and what is wrong. */
var COLOURS$1 = {
	calm: "var(--dim)",
	go: "var(--accent)",
	wait: "var(--wait)",
	good: "var(--good)",
	bad: "var(--bad)"
};
function DrivePanel({ id }) {
	const now = driveNow(id);
	tick.value;
	if (!now) return /* @__PURE__ */ a(Missing, { id });
	const { word, tone } = lookOfDrive(now);
	return /* @__PURE__ */ a(Panel, {
		title: now.id,
		tag: tell(now.name),
		colour: COLOURS$1[tone],
		children: [
			/* @__PURE__ */ a(Notes$1, { drive: now }),
			/* @__PURE__ */ a("dl", { children: [
				/* @__PURE__ */ a(Fact, {
					name: t("state"),
					children: /* @__PURE__ */ a("b", {
						class: tone,
						children: t(`drive_${word}`)
					})
				}),
				now.mode !== null && /* @__PURE__ */ a(Fact, {
					name: t(now.mode === "error" ? "error_fact" : "operation_fact"),
					children: [
						said$1(tell(now.meaning)) || "–",
						" ",
						/* @__PURE__ */ a("small", { children: now.code })
					]
				}),
				now.online && /* @__PURE__ */ a(Fact, {
					name: t("moves"),
					children: now.moving === null ? t("unknown") : t(now.moving ? "yes" : "no")
				}),
				now.output !== null && /* @__PURE__ */ a(Fact, {
					name: t("output"),
					children: now.output
				}),
				now.distance !== null && /* @__PURE__ */ a(Fact, {
					name: t("distance"),
					children: [
						hundredths(now.distance),
						" ",
						now.turn && /* @__PURE__ */ a("small", { children: ["· ", said$1(now.turn)] })
					]
				}),
				/* @__PURE__ */ a(Fact, {
					name: t("model"),
					children: now.model || t("no_model")
				}),
				/* @__PURE__ */ a(Fact, {
					name: t("on_line"),
					children: t("line_number", now.line, now.address)
				}),
				!now.online && /* @__PURE__ */ a(Fact, {
					name: t("seen"),
					children: now.seen ? t("ago", span(serverNow() - Date.parse(now.seen))) : "–"
				})
			] }),
			/* @__PURE__ */ a(StopKey, { drive: now }),
			/* @__PURE__ */ a(DriveTools, { drive: now }),
			/* @__PURE__ */ a(Parameters, { drive: now })
		]
	});
}
/** Stops the axis, or resets an error: at once, since a stop asks nobody whether he is sure. */
function StopKey({ drive }) {
	const error = useSignal(null);
	const done = useSignal(null);
	const press = () => {
		error.value = done.value = null;
		post(`/drives/${encodeURIComponent(drive.id)}/keys?wait=5`, { key: "stop_reset" }).then((operation) => done.value = operation, (failure) => error.value = failure);
	};
	return /* @__PURE__ */ a($, { children: [
		/* @__PURE__ */ a("div", {
			class: "buttons",
			children: /* @__PURE__ */ a(Button, {
				needs: "POST /drives/{drive}/keys",
				class: "halt",
				onClick: press,
				...stopped(againstDrive(drive, "harmless", around())),
				children: t("stop_reset")
			})
		}),
		/* @__PURE__ */ a(Problem, { error: error.value }),
		/* @__PURE__ */ a(Outcome, {
			operation: done.value,
			label: t("stop_reset")
		})
	] });
}
/** What is wrong with it, why it is not heard, who has locked it out. */
function Notes$1({ drive }) {
	return /* @__PURE__ */ a($, { children: [
		drive.mode === "error" && drive.online && /* @__PURE__ */ a("p", {
			class: "note alarm",
			children: [
				/* @__PURE__ */ a("b", { children: tell(drive.error || drive.meaning) }),
				" ",
				drive.remedy && /* @__PURE__ */ a("em", { children: tell(drive.remedy) })
			]
		}),
		!drive.online && drive.reason && /* @__PURE__ */ a("p", {
			class: "note held",
			children: [
				/* @__PURE__ */ a("b", { children: t(drive.online === null ? "drive_not_heard" : "drive_offline") }),
				" ",
				tell(drive.reason)
			]
		}),
		drive.lockout && /* @__PURE__ */ a("p", {
			class: "note held",
			children: [
				/* @__PURE__ */ a("b", { children: t("locked", drive.lockout.owner) }),
				" ",
				drive.lockout.reason
			]
		})
	] });
}
// src/parts/menu.ts
/** Give what the box with button and menu is to have: its ref, and what a key does in it. */
function useClosed(open) {
	const ref = T(null);
	A$1(() => {
		if (!open.value) return void 0;
		const press = (event) => {
			if (!ref.current?.contains(event.target)) open.value = false;
		};
		document.addEventListener("pointerdown", press);
		return () => document.removeEventListener("pointerdown", press);
	}, [open.value]);
	const onKeyDown = (event) => {
		if (event.key !== "Escape" || !open.value) return;
		open.value = false;
		ref.current?.querySelector("button")?.focus();
	};
	return {
		ref,
		onKeyDown
	};
}
// src/parts/Account.tsx
/** Who is here, with which roles; the password, and the way out. Where nobody logs in, only the name that they give themselves. */
function Account() {
	const who = me.value;
	return /* @__PURE__ */ a($, { children: [namesItself.value && /* @__PURE__ */ a(Actor, {}), who && !who.open && /* @__PURE__ */ a(Menu, {
		name: who.name ?? "",
		roles: who.roles,
		person: who.person
	})] });
}
function Actor() {
	const name = useSignal(actor());
	return /* @__PURE__ */ a("span", {
		class: "actor",
		children: /* @__PURE__ */ a("input", {
			value: name.value,
			maxLength: 64,
			"aria-label": t("your_name"),
			autocomplete: "name",
			title: t("name_hint"),
			placeholder: t("your_name"),
			onInput: (event) => {
				name.value = event.currentTarget.value;
				nameActor(name.value);
			}
		})
	});
}
function Menu({ name, roles, person }) {
	const open = useSignal(false);
	return /* @__PURE__ */ a("div", {
		...useClosed(open),
		class: "layers master account",
		children: [/* @__PURE__ */ a("button", {
			type: "button",
			"aria-expanded": open.value,
			title: inWords$2(roles),
			onClick: () => open.value = !open.value,
			children: [
				/* @__PURE__ */ a("b", { children: name }),
				" ",
				/* @__PURE__ */ a("small", { children: inWords$2(roles) })
			]
		}), open.value && /* @__PURE__ */ a("div", {
			role: "group",
			"aria-label": t("account"),
			children: [
				/* @__PURE__ */ a("dl", {
					class: "facts",
					children: [
						/* @__PURE__ */ a(Fact, {
							name: t("name"),
							children: name
						}),
						/* @__PURE__ */ a(Fact, {
							name: t("roles"),
							children: inWords$2(roles) || t("none")
						}),
						person && session.value && /* @__PURE__ */ a(Fact, {
							name: t("good_until"),
							children: clock(new Date(session.value.until).toISOString())
						}),
						!person && /* @__PURE__ */ a(Fact, {
							name: t("kind"),
							children: t("machine_key")
						})
					]
				}),
				person && /* @__PURE__ */ a(Password, {}),
				/* @__PURE__ */ a("div", {
					class: "acts-row",
					children: [/* @__PURE__ */ a("button", {
						type: "button",
						onClick: () => asked$2.value = true,
						children: t("log_in_as_other")
					}), /* @__PURE__ */ a("button", {
						type: "button",
						onClick: () => void logOut(),
						children: t("log_out")
					})]
				})
			]
		})]
	});
}
function Password() {
	const old = useSignal("");
	const next = useSignal("");
	const asking = useAsking();
	const send = async (event) => {
		event.preventDefault();
		const body = {
			old: old.value,
			new: next.value
		};
		if (await asking.ask(() => call("PUT", "/session/password", body), t("password_changed"))) old.value = next.value = "";
	};
	return /* @__PURE__ */ a("details", { children: [/* @__PURE__ */ a("summary", { children: t("change_password") }), /* @__PURE__ */ a("form", {
		class: "stack",
		onSubmit: (event) => void send(event),
		children: [
			/* @__PURE__ */ a(Field, {
				label: t("old_password"),
				name: "old",
				type: "password",
				value: old,
				required: true
			}),
			/* @__PURE__ */ a(Field, {
				label: t("new_password"),
				name: "new",
				type: "password",
				value: next,
				hint: t("password_rule"),
				required: true
			}),
			/* @__PURE__ */ a("div", {
				class: "acts-row",
				children: /* @__PURE__ */ a(Button, {
					needs: "PUT /session/password",
					type: "submit",
					disabled: asking.busy.value,
					children: t("change_password")
				})
			}),
			/* @__PURE__ */ a(Told, { asking })
		]
	})] });
}
// src/parts/Master.tsx
/** The plant as a whole: pause, stop all, resume; fires and earthquakes and their end. */
var FIRES = ["fire", "earthquake"];
/** Everything stops, pressed twice and without a word: whoever sees something go wrong has no time to write why. */
function StopAll() {
	const asking = useAsking();
	if (!controller.value) return null;
	return /* @__PURE__ */ a("span", {
		class: "stop-all",
		children: [/* @__PURE__ */ a(Sure, {
			class: "grave",
			needs: "POST /controller/stop",
			label: t("stop_all"),
			does: () => void asking.ask(() => post("/controller/stop", { reason: t("stopped_here") }))
		}), /* @__PURE__ */ a(Told, { asking })]
	});
}
function Master() {
	const open = useSignal(false);
	const asking = useAsking();
	const box = useClosed(open);
	const now = controller.value;
	const done = asking.done.value;
	A$1(() => {
		if (done) open.value = false;
	}, [done]);
	if (!now) return null;
	const emergencies = FIRES.filter((kind) => now.emergencies.some((words) => words.includes(kind)));
	return /* @__PURE__ */ a("div", {
		...box,
		class: "layers master",
		children: [/* @__PURE__ */ a("button", {
			type: "button",
			"aria-expanded": open.value,
			onClick: () => {
				asking.done.value = "";
				open.value = !open.value;
			},
			children: t("master")
		}), open.value && /* @__PURE__ */ a("div", {
			role: "group",
			"aria-label": t("master"),
			children: [
				now.emergencies.map((words) => /* @__PURE__ */ a("p", {
					class: "note alarm",
					children: tell(words)
				}, words)),
				/* @__PURE__ */ a("p", {
					class: "calm",
					children: t("reason_first")
				}),
				/* @__PURE__ */ a(Reasoned, {
					asking,
					decisions: [
						{
							label: t("pause"),
							needs: "POST /controller/pause",
							does: (reason) => post("/controller/pause", { reason })
						},
						{
							label: t("stop_all"),
							needs: "POST /controller/stop",
							grave: true,
							does: (reason) => post("/controller/stop", { reason })
						},
						...FIRES.filter((kind) => !emergencies.includes(kind)).map((kind) => ({
							label: t(`tell_${kind}`),
							needs: "POST /controller/emergency",
							grave: true,
							does: (reason) => post("/controller/emergency", {
								kind,
								reason
							})
						})),
						{
							label: t("resume"),
							needs: "POST /controller/resume",
							bare: true,
							idle: now.state === "auto",
							does: () => post("/controller/resume")
						},
						...emergencies.map((kind) => ({
							label: t(`release_${kind}`),
							needs: "POST /controller/emergency/release",
							grave: true,
							does: (reason) => post("/controller/emergency/release", {
								kind,
								reason
							})
						}))
					]
				})
			]
		})]
	});
}
// src/parts/Header.tsx
/** What the plant is, how it does, whether what is shown is live, who looks at it. */
function Header() {
	return /* @__PURE__ */ a("header", { children: [
		/* @__PURE__ */ a("h1", { children: [/* @__PURE__ */ a("svg", {
			viewBox: "0 0 32 32",
			width: "24",
			height: "24",
			"aria-hidden": "true",
			children: [/* @__PURE__ */ a("path", {
				d: "M3 8h26M16 8v8",
				stroke: "var(--accent)",
				"stroke-width": "3",
				"stroke-linecap": "round"
			}), /* @__PURE__ */ a("rect", {
				x: "9",
				y: "16",
				width: "14",
				height: "10",
				rx: "2",
				fill: "#f5b83d"
			})]
		}), "Hoistway"] }),
		/* @__PURE__ */ a("span", {
			class: "plant",
			children: layout.value?.name ?? ""
		}),
		/* @__PURE__ */ a(ControllerState, {}),
		/* @__PURE__ */ a(KeptOff, {}),
		!inPast.value && /* @__PURE__ */ a(Master, {}),
		!inPast.value && /* @__PURE__ */ a(StopAll, {}),
		/* @__PURE__ */ a("span", { class: "grow" }),
		/* @__PURE__ */ a(Counts, {}),
		/* @__PURE__ */ a(Account, {}),
		/* @__PURE__ */ a(Theme, {}),
		/* @__PURE__ */ a("button", {
			type: "button",
			class: "plain",
			onClick: () => speak(language.value === "en" ? "ko" : "en"),
			children: language.value === "en" ? "KO" : "EN"
		}),
		/* @__PURE__ */ a(LinkState, {})
	] });
}
function Rooms() {
	const alarms = alarmCount.value;
	return /* @__PURE__ */ a("nav", {
		class: "rooms",
		"aria-label": t("rooms"),
		children: (recording.value ? ["playback"] : ROOMS).map((name) => /* @__PURE__ */ a("button", {
			type: "button",
			"aria-current": room$1.value === name ? "page" : void 0,
			onClick: () => room$1.value = name,
			children: [t(name), name === "alarms" && alarms > 0 && /* @__PURE__ */ a("b", {
				class: "badge",
				title: t("alarm_count_title", unacknowledged.value),
				children: ["! ", alarms]
			})]
		}, name))
	});
}
function Theme() {
	const other = theme.value === "dark" ? "light" : "dark";
	return /* @__PURE__ */ a("button", {
		type: "button",
		class: "plain",
		title: t(`theme_${other}`),
		"aria-label": t(`theme_${other}`),
		onClick: () => choose$1(other),
		children: other === "light" ? "☀" : "☾"
	});
}
function ControllerState() {
	const now = controller.value;
	if (!now) return /* @__PURE__ */ a("span", {
		class: "pill",
		children: t("unknown")
	});
	const emergency = (now.emergencies ?? []).join(", ");
	const grave = now.trouble || emergency;
	const tone = grave ? "bad" : now.state === "auto" ? "good" : "wait";
	const roll = now.waiting_for.length ? t("waiting_for", now.waiting_for.join(", ")) : "";
	const why = tell(notice.value || grave || now.reason || roll);
	return /* @__PURE__ */ a($, { children: [/* @__PURE__ */ a("span", {
		class: `pill ${away$1.value ? "" : tone}`,
		title: t("controller"),
		children: away$1.value ? t("state_then", said$1(now.state), lastHeard()) : said$1(now.state)
	}), /* @__PURE__ */ a("span", {
		class: `why ${grave ? "bad" : ""}`,
		role: "status",
		title: why,
		children: why
	})] });
}
function Counts() {
	const looks = /* @__PURE__ */ new Map();
	for (const vehicle of vehicleList.value) looks.set(lookOf(vehicle), (looks.get(lookOf(vehicle)) ?? 0) + 1);
	const open = jobList.value.filter((job) => !ENDED.has(job.state)).length;
	return /* @__PURE__ */ a("span", {
		class: "counts",
		children: [
			/* @__PURE__ */ a("span", { children: [
				/* @__PURE__ */ a("b", { children: counted(vehicleList.value.length) }),
				" ",
				t("vehicles")
			] }),
			[
				"alarm",
				"held",
				"gone"
			].map((look) => looks.has(look) && /* @__PURE__ */ a("span", {
				style: { color: LOOKS[look] },
				title: t("look_count_title", t(`look_${look}`)),
				children: [
					/* @__PURE__ */ a("b", { children: looks.get(look) }),
					" ",
					t(`look_${look}`)
				]
			}, look)),
			/* @__PURE__ */ a("span", { children: [
				/* @__PURE__ */ a("b", { children: counted(open) }),
				" ",
				t("open_jobs")
			] })
		]
	});
}
function LinkState() {
	tick.value;
	const state = link.value;
	if (inPast.value) return /* @__PURE__ */ a("span", {
		class: state === "lost" ? "link lost" : "link past",
		role: "status",
		children: [/* @__PURE__ */ a("i", { class: "dot" }), t(state === "lost" ? "past_away" : "playback")]
	});
	const age = heardAt.value ? Math.round((Date.now() - heardAt.value) / 1e3) : null;
	const text = state === "live" ? t("live") : state === "connecting" ? t("connecting") : age === null ? t("lost_none") : t("lost_age", age);
	return /* @__PURE__ */ a("span", {
		class: `link ${state}`,
		role: "status",
		"aria-live": "polite",
		children: [/* @__PURE__ */ a("i", { class: "dot" }), text]
	});
}
// src/phases.ts
/** What ends a phase; the last of them counts, since an assignment may have been another's before; none before it was taken back does. */
var ENDS = [
	["queued", "VehicleAssigned"],
	["fetching", "VehicleAcquireStarted"],
	["acquiring", "VehicleAcquireCompleted"],
	["carrying", "VehicleDepositStarted"],
	["depositing", "VehicleDepositCompleted"]
];
/** The last event by which the job lost its vehicle and went on, its index; -1: none. At its end it loses it, too: `over`. */
function lastTakenBack(events, over) {
	const assigned = events.findLastIndex(({ event }) => event === "VehicleAssigned");
	return events.findLastIndex(({ event }, i) => event === "VehicleUnassigned" && (!over || i < assigned));
}
/** Phases with their seconds, in order; the one under way lasts until `now` (ms), null: the job is over. */
function phasesOf(created, now, events) {
	const found = [];
	const since = events.slice(lastTakenBack(events, now === null) + 1);
	let from = Date.parse(created);
	for (const [name, end] of ENDS) {
		const ended = since.findLast(({ event }) => event === end);
		const to = ended ? Date.parse(ended.ts) : now;
		if (to === null || to < from) break;
		found.push({
			name,
			took: (to - from) / 1e3
		});
		if (!ended) break;
		from = to;
	}
	return found;
}
// src/parts/JobPanel.tsx
/** One job: its phases, why this vehicle, what it waited for, its events, and all that can be done about it. */
var COLOURS = {
	calm: "var(--dim)",
	go: "var(--accent)",
	wait: "var(--wait)",
	good: "var(--good)",
	bad: "var(--bad)"
};
var EVERY$4 = 3;
function JobPanel({ id }) {
	const why = useSignal(null);
	const whole = useSignal(null);
	const error = useSignal(null);
	const job = jobList.value.find((job) => job.id === id) ?? whole.value;
	const over = job ? ENDED.has(job.state) : false;
	const round = over ? 0 : Math.floor(tick.value / EVERY$4);
	A$1(() => {
		const path = `/jobs/${encodeURIComponent(id)}`;
		get(`${path}/why`).then((found) => why.value = found, (failure) => error.value = failure);
		get(path).then((found) => whole.value = found, (failure) => error.value = failure);
	}, [
		id,
		job?.state,
		job?.vehicle,
		round
	]);
	if (!job) return /* @__PURE__ */ a(Panel, {
		title: id,
		tag: t("job"),
		colour: "var(--dim)",
		children: /* @__PURE__ */ a(Problem, { error: error.value })
	});
	const tone = TONES$2[job.state] ?? "calm";
	const before = job.vehicle ? null : whole.value?.history[lastTakenBack(whole.value.history, over)]?.vehicle;
	return /* @__PURE__ */ a(Panel, {
		title: job.id,
		tag: said$1(job.state),
		colour: COLOURS[tone],
		children: [
			job.reason && !over && /* @__PURE__ */ a("p", {
				class: "note waits",
				children: [
					/* @__PURE__ */ a("b", { children: t("waits") }),
					" ",
					tell(job.reason)
				]
			}),
			!over && /* @__PURE__ */ a(CutOff, { id: job.source }),
			!over && /* @__PURE__ */ a(CutOff, { id: job.destination }),
			/* @__PURE__ */ a("dl", { children: [
				/* @__PURE__ */ a(Fact, {
					name: t("source"),
					children: /* @__PURE__ */ a(Name, { id: job.source })
				}),
				/* @__PURE__ */ a(Fact, {
					name: t("destination"),
					children: [/* @__PURE__ */ a(Name, { id: job.destination }), job.fallbacks.length > 0 && /* @__PURE__ */ a("small", { children: [" · ", t("fallbacks", job.fallbacks.join(", "))] })]
				}),
				/* @__PURE__ */ a(Fact, {
					name: t("carrier"),
					children: job.carrier ?? t("unknown")
				}),
				/* @__PURE__ */ a(Fact, {
					name: t("vehicle"),
					children: [
						job.vehicle ? /* @__PURE__ */ a(Name, { id: job.vehicle }) : t("none"),
						before && /* @__PURE__ */ a("small", { children: [
							" ",
							"· ",
							t("had_before"),
							" ",
							/* @__PURE__ */ a(Name, { id: before })
						] }),
						job.wish && /* @__PURE__ */ a("small", { children: [" · ", t("wished", job.wish)] })
					]
				}),
				/* @__PURE__ */ a(Fact, {
					name: t("priority"),
					children: job.priority
				}),
				/* @__PURE__ */ a(Fact, {
					name: t("ordered_by"),
					children: [
						job.actor,
						" ",
						/* @__PURE__ */ a("small", { children: ["· ", clock(job.created)] })
					]
				}),
				over && /* @__PURE__ */ a(Fact, {
					name: t("result"),
					children: tell(job.result || job.reason) || said$1(job.state)
				})
			] }),
			whole.value && /* @__PURE__ */ a(Phases$1, {
				job,
				events: whole.value.history
			}),
			!over && /* @__PURE__ */ a(Change$1, { job }),
			why.value && /* @__PURE__ */ a(Why, {
				why: why.value,
				events: whole.value?.history ?? [],
				over
			}),
			whole.value && /* @__PURE__ */ a(History, { events: whole.value.history }),
			/* @__PURE__ */ a(Problem, { error: error.value })
		]
	});
}
var seconds$1 = (value) => value >= 100 ? `${Math.round(value)} s` : `${value.toFixed(1)} s`;
/** How long it lay, was fetched, picked up, carried and put down: drawn to scale. */
function Phases$1({ job, events }) {
	const phases = phasesOf(job.created, ENDED.has(job.state) ? null : serverNow(), events);
	if (phases.length === 0) return null;
	return /* @__PURE__ */ a("section", {
		class: "part",
		children: [
			/* @__PURE__ */ a("h3", { children: t("phases") }),
			/* @__PURE__ */ a("div", {
				class: "phases",
				children: phases.map(({ name, took }) => /* @__PURE__ */ a("span", {
					class: name,
					style: { flex: `${Math.max(took, .01)} 1 0` },
					title: `${t(`phase_${name}`)} ${seconds$1(took)}`,
					children: seconds$1(took)
				}, name))
			}),
			/* @__PURE__ */ a("small", {
				class: "calm",
				children: phases.map(({ name, took }) => `${t(`phase_${name}`)} ${seconds$1(took)}`).join(" · ")
			})
		]
	});
}
function Why({ why, events, over }) {
	return /* @__PURE__ */ a($, { children: [/* @__PURE__ */ a("section", {
		class: "part why-list",
		children: [
			/* @__PURE__ */ a("h3", { children: t("why_vehicle") }),
			why.assignments.length === 0 && /* @__PURE__ */ a("p", {
				class: "nothing",
				children: t("not_assigned_yet")
			}),
			why.assignments.map((choice) => /* @__PURE__ */ a(Choice, {
				choice,
				until: takenBack(choice, events.slice(0, lastTakenBack(events, over) + 1))
			}, choice.at + choice.vehicle))
		]
	}), /* @__PURE__ */ a("section", {
		class: "part why-list",
		children: [
			/* @__PURE__ */ a("h3", { children: t("why_waits") }),
			why.waits.length === 0 && /* @__PURE__ */ a("p", {
				class: "nothing",
				children: t("never_waited")
			}),
			/* @__PURE__ */ a("table", { children: /* @__PURE__ */ a("tbody", { children: why.waits.map((wait) => /* @__PURE__ */ a("tr", { children: [
				/* @__PURE__ */ a("td", { children: clock(wait.since) }),
				/* @__PURE__ */ a("td", { children: wait.seconds === null ? t("still") : seconds$1(wait.seconds) }),
				/* @__PURE__ */ a("td", { children: tell(wait.reason) })
			] }, wait.since + wait.reason)) }) }),
			why.left_out > 0 && /* @__PURE__ */ a("small", {
				class: "calm",
				children: t("left_out", why.left_out)
			})
		]
	})] });
}
/** When a vehicle lost the job that it was given, by the events up to when the job was last taken back; null: it did not. */
function takenBack({ vehicle, at }, events) {
	return events.find((event) => event.event === "VehicleUnassigned" && event.vehicle === vehicle && event.ts >= at)?.ts ?? null;
}
function Choice({ choice, until }) {
	return /* @__PURE__ */ a("div", {
		class: "choice",
		children: [
			/* @__PURE__ */ a("b", { children: [
				/* @__PURE__ */ a(Name, { id: choice.vehicle }),
				" · ",
				t("to_source", seconds$1(choice.seconds))
			] }),
			" ",
			/* @__PURE__ */ a("small", {
				class: "calm",
				children: clock(choice.at)
			}),
			until && /* @__PURE__ */ a("p", {
				class: "wait",
				children: t("taken_back", clock(until))
			}),
			/* @__PURE__ */ a("div", { children: [
				choice.hot && `${t("hot_lot")} · `,
				choice.before && choice.saved !== null && `${t("instead_of", choice.before, seconds$1(choice.saved))} · `,
				t("worth", seconds$1(choice.waited), seconds$1(choice.switch))
			] }),
			choice.candidates.length > 0 && /* @__PURE__ */ a("table", { children: /* @__PURE__ */ a("tbody", { children: choice.candidates.map((other) => /* @__PURE__ */ a("tr", { children: [
				/* @__PURE__ */ a("td", { children: /* @__PURE__ */ a(Name, { id: other.vehicle }) }),
				/* @__PURE__ */ a("td", { children: other.seconds === null ? t("no_way") : seconds$1(other.seconds) }),
				/* @__PURE__ */ a("td", { children: tell(other.why_not) })
			] }, other.vehicle)) }) })
		]
	});
}
function History({ events }) {
	return /* @__PURE__ */ a("details", {
		class: "part",
		children: [/* @__PURE__ */ a("summary", { children: [
			t("events"),
			" ",
			events.length
		] }), /* @__PURE__ */ a("table", {
			class: "bits",
			children: /* @__PURE__ */ a("tbody", { children: events.map((event) => /* @__PURE__ */ a("tr", { children: [
				/* @__PURE__ */ a("th", { children: clock(event.ts) }),
				/* @__PURE__ */ a("td", { children: ["#", event.seq] }),
				/* @__PURE__ */ a("td", { children: [
					happening(event.event),
					" ",
					[
						event.vehicle,
						event.result && said$1(event.result),
						event.detail !== event.result && tell(event.detail)
					].filter(Boolean).join(" · ")
				] })
			] }, event.seq)) })
		})]
	});
}
var CANCELLABLE$1 = /* @__PURE__ */ new Set(["queued", "waiting"]);
var ABORTABLE$1 = /* @__PURE__ */ new Set(["transferring", "paused"]);
/** Other priority, destination or vehicle; or its end. */
function Change$1({ job }) {
	const error = useSignal(null);
	const done = useSignal(false);
	const priority = useSignal(String(job.priority));
	const destination = useSignal(job.destination);
	const vehicle = useSignal(job.wish ?? "");
	const reason = useSignal("");
	changes.stations.value;
	const path = `/jobs/${encodeURIComponent(job.id)}`;
	const taken = !CANCELLABLE$1.has(job.state);
	const report = (asked) => {
		error.value = null;
		done.value = false;
		asked.then(() => done.value = true, (failure) => error.value = failure);
	};
	const body = {
		...Number(priority.value) !== job.priority ? { priority: Number(priority.value) } : {},
		...destination.value !== job.destination ? { destination: destination.value } : {},
		...vehicle.value !== (job.wish ?? "") ? { vehicle: vehicle.value || null } : {}
	};
	const end = (how) => report(post(`${path}/${how}`, { reason: reason.value.trim() }));
	return /* @__PURE__ */ a("form", {
		class: "part",
		onSubmit: (event) => {
			event.preventDefault();
			report(call("PATCH", path, body));
		},
		children: [
			/* @__PURE__ */ a("h3", { children: t("change") }),
			/* @__PURE__ */ a("div", {
				class: "fields",
				children: [
					/* @__PURE__ */ a("label", { children: [/* @__PURE__ */ a("span", { children: t("priority") }), /* @__PURE__ */ a("input", {
						name: "priority",
						type: "number",
						min: "0",
						max: "99",
						required: true,
						value: priority.value,
						onInput: (event) => priority.value = event.currentTarget.value
					})] }),
					/* @__PURE__ */ a("label", { children: [/* @__PURE__ */ a("span", { children: t("vehicle") }), /* @__PURE__ */ a("input", {
						name: "vehicle",
						disabled: taken,
						title: taken ? t("against_other_vehicle", job.vehicle ?? "") : "",
						list: "vehicle-names",
						autocomplete: "off",
						placeholder: t("any"),
						value: vehicle.value,
						onInput: (event) => vehicle.value = event.currentTarget.value.trim()
					})] }),
					/* @__PURE__ */ a("label", {
						class: "wide",
						children: [/* @__PURE__ */ a("span", { children: t("destination") }), /* @__PURE__ */ a("input", {
							name: "destination",
							list: "station-names",
							autocomplete: "off",
							required: true,
							value: destination.value,
							onInput: (event) => destination.value = event.currentTarget.value.trim()
						})]
					})
				]
			}),
			(CANCELLABLE$1.has(job.state) || ABORTABLE$1.has(job.state)) && /* @__PURE__ */ a("div", {
				class: "fields",
				children: /* @__PURE__ */ a("label", {
					class: "wide",
					children: [/* @__PURE__ */ a("span", { children: t("reason_of_end") }), /* @__PURE__ */ a("input", {
						name: "reason",
						maxLength: 200,
						autocomplete: "off",
						placeholder: t("may_be_empty"),
						value: reason.value,
						onInput: (event) => reason.value = event.currentTarget.value
					})]
				})
			}),
			/* @__PURE__ */ a("datalist", {
				id: "vehicle-names",
				children: layout.value?.vehicles.map(({ id }) => /* @__PURE__ */ a("option", { value: id }, id))
			}),
			/* @__PURE__ */ a("datalist", {
				id: "station-names",
				children: layout.value?.stations.map(({ id }) => /* @__PURE__ */ a("option", { value: id }, id))
			}),
			/* @__PURE__ */ a("div", {
				class: "acts-row",
				children: [
					/* @__PURE__ */ a(Button, {
						needs: "PATCH /jobs/{job}",
						type: "submit",
						class: "primary",
						disabled: Object.keys(body).length === 0,
						children: t("change")
					}),
					CANCELLABLE$1.has(job.state) && /* @__PURE__ */ a(Sure, {
						needs: "POST /jobs/{job}/cancel",
						label: t("cancel"),
						does: () => end("cancel")
					}),
					ABORTABLE$1.has(job.state) && /* @__PURE__ */ a(Sure, {
						needs: "POST /jobs/{job}/abort",
						label: t("abort"),
						does: () => end("abort")
					}),
					done.value && /* @__PURE__ */ a("span", {
						class: "done",
						role: "status",
						children: t("taken")
					})
				]
			}),
			/* @__PURE__ */ a(Problem, { error: error.value })
		]
	});
}
// src/parts/JobRoom.tsx
/** All jobs in a table: open ones live, ended ones from the history, older ones on demand. */
var PAGE = 200;
var STATES = [
	"queued",
	"waiting",
	"transferring",
	"paused",
	"cancelling",
	"aborting",
	"completed",
	"failed",
	"cancelled",
	"aborted"
];
function JobRoom() {
	const letters = useSignal("");
	const state = useSignal("");
	const older = useSignal([]);
	const error = useSignal(null);
	tick.value;
	const known = new Set(jobList.value.map((job) => job.id));
	const all = [...jobList.value, ...older.value.filter((job) => !known.has(job.id))];
	const wanted = letters.value.trim().toLowerCase();
	const hits = (job) => [
		job.id,
		job.source,
		job.destination,
		job.carrier,
		job.vehicle,
		job.actor
	].some((name) => name?.toLowerCase().includes(wanted) ?? false);
	const rows = all.filter((job) => (!state.value || (state.value === "open" ? !ENDED.has(job.state) : job.state === state.value)) && hits(job));
	const more = async () => {
		error.value = null;
		const oldest = all.filter((job) => ENDED.has(job.state)).reduce((least, job) => Math.min(least, job.order), Number.MAX_SAFE_INTEGER);
		try {
			const { items } = await get(`/jobs?limit=${PAGE}&after=${oldest}`);
			older.value = [...older.value, ...items.filter((job) => ENDED.has(job.state))];
		} catch (failure) {
			error.value = failure;
		}
	};
	return /* @__PURE__ */ a("section", {
		class: "room",
		"aria-label": t("jobs"),
		children: [/* @__PURE__ */ a("div", {
			class: "head",
			children: [
				/* @__PURE__ */ a("h2", { children: [
					t("jobs"),
					" ",
					counted(rows.length)
				] }),
				/* @__PURE__ */ a(Problem, { error: error.value }),
				/* @__PURE__ */ a("button", {
					type: "button",
					onClick: () => void more(),
					children: t("older")
				}),
				/* @__PURE__ */ a("select", {
					"aria-label": t("state"),
					value: state.value,
					onChange: (event) => state.value = event.currentTarget.value,
					children: [
						/* @__PURE__ */ a("option", {
							value: "",
							children: t("all")
						}),
						/* @__PURE__ */ a("option", {
							value: "open",
							children: t("open")
						}),
						STATES.map((name) => /* @__PURE__ */ a("option", {
							value: name,
							children: said$1(name)
						}, name))
					]
				}),
				/* @__PURE__ */ a("input", {
					type: "search",
					"aria-label": t("filter"),
					placeholder: t("filter"),
					value: letters.value,
					onInput: (event) => letters.value = event.currentTarget.value
				})
			]
		}), /* @__PURE__ */ a(Table, {
			label: t("jobs"),
			rows,
			keyOf: (job) => job.id,
			pick: ({ id }) => selected.value = {
				kind: "job",
				id
			},
			chosen: selected.value?.kind === "job" ? selected.value.id : null,
			none: t(all.length ? "no_match" : "no_jobs"),
			columns: [
				{
					name: t("job"),
					by: (job) => job.order,
					of: ({ id }) => /* @__PURE__ */ a("button", {
						type: "button",
						class: "text",
						onClick: () => selected.value = {
							kind: "job",
							id
						},
						children: id
					})
				},
				{
					name: t("state"),
					by: (job) => said$1(job.state),
					of: (job) => /* @__PURE__ */ a("span", {
						class: `state ${TONES$2[job.state] ?? "calm"}`,
						children: said$1(job.state)
					})
				},
				{
					name: t("priority"),
					by: (job) => job.priority,
					of: (job) => job.priority,
					number: true
				},
				{
					name: t("source"),
					by: (job) => job.source,
					of: (job) => /* @__PURE__ */ a(Name, { id: job.source })
				},
				{
					name: t("destination"),
					by: (job) => job.destination,
					of: (job) => /* @__PURE__ */ a(Name, { id: job.destination })
				},
				{
					name: t("carrier"),
					by: (job) => job.carrier,
					of: (job) => job.carrier ?? ""
				},
				{
					name: t("vehicle"),
					by: (job) => job.vehicle,
					of: (job) => /* @__PURE__ */ a(Name, { id: job.vehicle })
				},
				{
					name: t("ordered_at"),
					by: (job) => job.created,
					of: (job) => clock(job.created)
				},
				{
					name: t("takes"),
					by: (job) => took(job),
					of: (job) => elapsed(job, serverNow()),
					number: true
				},
				{
					name: t("why"),
					wraps: true,
					of: (job) => tell(ENDED.has(job.state) ? job.result || job.reason : job.reason)
				}
			]
		})]
	});
}
function took(job) {
	return (job.ended ? Date.parse(job.ended) : serverNow()) - Date.parse(job.created);
}
// src/past/reel.ts
/** Where what is listed in the first line of an answer begins, and the line itself. */
function headOf(body) {
	const end = body.indexOf(10);
	return {
		head: JSON.parse(new TextDecoder().decode(body.subarray(0, end))),
		from: end + 1
	};
}
async function unpacked(body) {
	const plain = new Blob([body]).stream().pipeThrough(new DecompressionStream("deflate"));
	return await new Response(plain).json();
}
/** Give the pieces of an answer one after the other, so that nothing else has to wait for all of them. */
async function* piecesOf(body) {
	const { head, from } = headOf(body);
	let at = from;
	for (const { id, kind, begin, end, size } of head.items) {
		const content = await unpacked(body.subarray(at, at + size));
		at += size;
		yield kind === "state" ? {
			id,
			begin,
			end,
			state: content
		} : {
			id,
			begin,
			end,
			changes: content
		};
	}
}
/** A whole state is shown on the way at most so often, s. */
var ANEW = 55;
/** So many changes are kept before those that are furthest back go. */
var MOST$2 = 25e4;
var Reel = class {
	pieces = [];
	count = 0;
	/** What comes next: the piece, and the change in it. */
	index = 0;
	within = 0;
	/** What is shown; NaN: nothing yet. */
	now = NaN;
	/** Of when the last whole state that was shown is. */
	wholeAt = Number.NEGATIVE_INFINITY;
	/** All that happened before this moment is here, s. */
	until = Number.NEGATIVE_INFINITY;
	clear() {
		this.pieces = [];
		this.count = this.index = this.within = 0;
		this.now = NaN;
		this.wholeAt = Number.NEGATIVE_INFINITY;
		this.until = Number.NEGATIVE_INFINITY;
	}
	/** Put a piece behind the others. */
	add(piece) {
		this.pieces.push(piece);
		this.count += piece.changes?.length ?? 0;
		this.until = Math.max(this.until, piece.end);
	}
	get last() {
		return this.pieces.at(-1)?.id ?? null;
	}
	/** The first moment that can be shown. */
	get begin() {
		return this.pieces[0]?.begin ?? Number.POSITIVE_INFINITY;
	}
	holds(at) {
		return this.begin <= at && at <= this.until;
	}
	/** Show a moment: go on to it if nothing whole lies between, else make it of the whole state before it. */
	seek(at, screen) {
		let from = 0;
		this.pieces.forEach((piece, i) => {
			if (piece.state && piece.begin <= at) from = i;
		});
		if (this.now <= at && from < this.index) this.forward(at, screen);
		else this.make(from, at, screen);
	}
	/** All changes since a whole state brought into it, and shown at once: most objects change many times. */
	make(from, at, screen) {
		const state = {};
		for (const [topic, objects] of Object.entries(this.pieces[from]?.state ?? {})) state[topic] = { ...objects };
		const own = /* @__PURE__ */ new Set();
		this.index = from;
		this.within = 0;
		this.wholeAt = Number.NEGATIVE_INFINITY;
		this.forward(at, {
			whole: () => void 0,
			change: ([, topic, key, value]) => {
				const objects = state[topic] ??= {};
				const before = objects[key];
				if (value === null) delete objects[key];
				else if (topic !== "vehicles" || !before) objects[key] = value;
				else if (own.has(before)) Object.assign(before, value);
				else own.add(objects[key] = {
					...before,
					...value
				});
			}
		});
		screen.whole(state);
	}
	/** Go on to a moment that is not before the present one. */
	forward(at, screen) {
		this.now = at;
		for (let piece = this.pieces[this.index]; piece; piece = this.pieces[this.index]) {
			if (piece.state) {
				if (piece.begin > at && this.index > 0) return;
				if (this.index === 0 || piece.begin - this.wholeAt >= ANEW) {
					this.wholeAt = piece.begin;
					screen.whole(piece.state);
				}
			} else {
				const changes = piece.changes ?? [];
				for (; this.within < changes.length; this.within++) {
					const change = changes[this.within];
					if (change[0] > at) return;
					screen.change(change);
				}
			}
			this.index++;
			this.within = 0;
		}
	}
	/** Let go of what lies furthest back if there is very much of it, up to a whole state; returns from when on there is something. */
	trim() {
		while (this.count > MOST$2) {
			const next = this.pieces.findIndex((piece, i) => i > 0 && piece.state);
			if (next < 0 || next >= this.index) break;
			for (const piece of this.pieces.splice(0, next)) this.count -= piece.changes?.length ?? 0;
			this.index -= next;
		}
		return this.begin;
	}
};
// src/glide.ts
/** The drawn one runs on at its last pace for so long when no report comes, s. */
var RUN_ON = 1.2;
/** Reports lag and jump: share of the gap to make good per second. */
var CATCH_UP = 2.5;
/** A gap longer than this is not driven but jumped, mm. */
var JUMP = 12e3;
/** Track kept behind the front, so that the hull bends with the rail, mm. */
var TAIL$1 = 1500;
var Glide = class {
	track;
	topSpeed;
	path = [];
	/** The ways between the barcodes of the path: `ways[i]` leads from `path[i]` on. */
	ways = [];
	s = 0;
	reported = 0;
	/** Index in the path of the barcode that was reported last: track driven both ways may have it twice. */
	here = 0;
	pace = 0;
	since = 0;
	moving = false;
	last = 0;
	constructor(track, topSpeed = 3e3) {
		this.track = track;
		this.topSpeed = topSpeed;
	}
	/** Take a report at `now` (s). */
	report(report, now) {
		const { barcode } = report;
		if (barcode === null || !this.track.points.has(barcode)) {
			this.lay([]);
			return;
		}
		const ahead = this.connected(barcode, report.granted);
		const reached = this.reach(barcode, ahead);
		let offset = this.lengthTo(reached ?? 0);
		this.here = reached ?? 0;
		if (reached === null) {
			const tail = this.tail(barcode);
			this.lay([...tail, ...ahead]);
			this.here = tail.length;
			offset = this.lengthTo(tail.length);
		}
		const at = offset + Math.max(0, report.dist ?? 0);
		if (reached === null) this.s = Math.min(at, this.lengthTo(this.path.length - 1));
		const travelled = reached === null ? 0 : at - this.reported;
		this.moving = report.moving;
		if (!report.moving || reached === null) this.pace = 0;
		else if (travelled < 1) return;
		else this.learn(travelled, now - this.since);
		this.reported = at;
		this.since = now;
	}
	/** Drive on to `now` (s). `still`: jump to where the report says. */
	drive(now, still = false) {
		const dt = Math.min(Math.max(now - this.last, 0), .25);
		this.last = now;
		const end = this.lengthTo(this.path.length - 1);
		const run = this.moving && !still ? this.pace * Math.min(now - this.since, RUN_ON) : 0;
		const goal = Math.min(this.reported + run, Math.max(end, this.s));
		const gap = goal - this.s;
		if (still || Math.abs(gap) > JUMP) this.s = goal;
		else if (gap > 0) {
			const pace = Math.min(this.topSpeed * 1.3, (this.moving ? this.pace : 0) + gap * CATCH_UP);
			this.s = Math.min(goal, this.s + Math.max(pace, 150) * dt);
		} else if (!this.moving) this.s = Math.max(goal, this.s + Math.min(-150, gap * CATCH_UP) * dt);
		this.trim();
		return this;
	}
	/** Where the point lies that is `back` mm behind its front; null while its place is not known. */
	middle(back = 0) {
		let rest = this.s - back;
		for (let i = 0; i + 1 < this.path.length; i++) {
			const way = this.ways[i];
			if (!way) break;
			if (rest <= way.edge.length || i + 2 === this.path.length) return behind(this.track.along(way, rest), -rest);
			rest -= way.edge.length;
		}
		const first = this.path[0];
		const spot = first === void 0 ? void 0 : this.track.spot(first);
		return spot ? behind(spot, back - this.s) : null;
	}
	/** Whether the drawn place still differs from the reported one. */
	get busy() {
		return this.moving || Math.abs(this.reported - this.s) > 5;
	}
	/** The report's own path, as far as edges join it; at least one edge on, to have a heading and room for `dist`. */
	connected(barcode, granted) {
		const path = [barcode];
		for (const step of granted) {
			const here = path[path.length - 1];
			if (step === here) continue;
			if (!this.track.way(here, step)) break;
			path.push(step);
		}
		const only = this.track.next.get(barcode);
		if (path.length === 1 && only?.length === 1) path.push(only[0].end);
		return path;
	}
	/** Lay the report's path behind the drawn place; returns the index of its barcode, or null if it is elsewhere. */
	reach(barcode, ahead) {
		if (this.path.length === 0) return null;
		const onward = this.path.indexOf(barcode, this.here);
		const known = onward >= 0 ? onward : this.path.lastIndexOf(barcode);
		if (known >= 0) {
			this.lay([...this.path.slice(0, known), ...ahead]);
			return known;
		}
		const from = this.index();
		const way = this.track.path(this.path[from], barcode);
		if (!way) return null;
		const path = [...this.path.slice(0, from), ...way];
		this.lay([...path.slice(0, -1), ...ahead]);
		return this.lengthTo(path.length - 1) - this.s > JUMP ? null : path.length - 1;
	}
	learn(travelled, took) {
		if (took < .02) return;
		const measured = Math.min(travelled / took, this.topSpeed);
		this.pace = this.pace === 0 ? measured : this.pace * .5 + measured * .5;
	}
	/** The barcodes before one, as long as there is only one way to have come. */
	tail(barcode) {
		const path = [];
		for (let length = 0, here = barcode; length < TAIL$1;) {
			const [edge, other] = this.track.before.get(here) ?? [];
			if (!edge || other || path.includes(edge.start)) break;
			path.unshift(edge.start);
			length += edge.length;
			here = edge.start;
		}
		return path;
	}
	lay(path) {
		this.path = path;
		this.ways = path.slice(1).map((end, i) => this.track.way(path[i], end));
	}
	lengthTo(index) {
		let sum = 0;
		for (let i = 0; i < index; i++) sum += this.ways[i]?.edge.length ?? 0;
		return sum;
	}
	/** Which edge of the path the drawn front is on. */
	index() {
		let i = 0;
		while (i + 2 < this.path.length && this.lengthTo(i + 1) <= this.s) i++;
		return i;
	}
	trim() {
		while (this.path.length > 2) {
			const length = this.ways[0]?.edge.length ?? 0;
			if (this.s < length + TAIL$1 || this.reported < length) return;
			this.path.shift();
			this.ways.shift();
			this.here = Math.max(0, this.here - 1);
			this.s -= length;
			this.reported -= length;
		}
	}
};
/** Straight back from a place, for as long as there is no track known behind it. */
function behind(spot, mm) {
	const more = Math.max(0, mm);
	return {
		x: spot.x - Math.cos(spot.angle) * more,
		y: spot.y - Math.sin(spot.angle) * more,
		angle: spot.angle
	};
}
// src/past/trails.ts
/**
* Where to draw a vehicle at a moment of the past: it is known when it came by one barcode and when by the next, and it is drawn
* between them by the time. Pure.
*/
/** One that was not said to drive gets to its next barcode in the last so many seconds before it is there. */
var LEAP = 1;
/** Nothing drives faster; whatever would have is not drawn on its way, mm/s. */
var FASTEST$1 = 6e3;
/** Track known behind the barcode, so that the hull bends with the rail, mm. */
var TAIL = 1500;
var Course = class {
	marks = [];
	/** The mark at or before the moment asked about last, and the ways about it. */
	index = 0;
	drawn = -1;
	ways = [];
	/** Where on those ways the barcode of the mark lies, and how far it is to the next, mm. */
	offset = 0;
	length = 0;
	add(mark) {
		const last = this.marks.at(-1);
		if (last?.barcode === mark.barcode && last.moves === mark.moves) return;
		if (this.drawn === this.marks.length - 1) this.drawn = -1;
		this.marks.push(mark);
	}
	trim(before) {
		let count = 0;
		while (count + 4 < this.marks.length && this.marks[count + 3].at < before) count++;
		if (count < 500) return;
		this.marks.splice(0, count);
		this.index = Math.max(0, this.index - count);
		this.drawn = -1;
	}
	spot(track, at, back, still) {
		const mark = this.find(at);
		if (!mark?.barcode || mark.at > at) return null;
		if (this.drawn !== this.index) this.draw(track, mark);
		const next = this.marks[this.index + 1];
		const s = this.offset + (still || !next ? 0 : this.length * share(mark, next, at));
		return place(track, this.ways, s - back) ?? rest(track, mark.barcode, back);
	}
	find(at) {
		const { marks } = this;
		let low = this.index;
		if ((marks[low]?.at ?? Number.POSITIVE_INFINITY) > at) low = 0;
		let step = 1;
		while ((marks[low + step]?.at ?? Number.POSITIVE_INFINITY) <= at) {
			low += step;
			step *= 2;
		}
		while (step >= 1) {
			if ((marks[low + step]?.at ?? Number.POSITIVE_INFINITY) <= at) low += step;
			step >>= 1;
		}
		this.index = low;
		return marks[low];
	}
	/** Lay out the ways by which it came, and the one that leads on. */
	draw(track, mark) {
		this.drawn = this.index;
		const behindIt = [];
		let length = 0;
		for (let i = this.index; i > 0 && length < TAIL; i--) {
			const [from, to] = [this.marks[i - 1]?.barcode, this.marks[i]?.barcode];
			if (from === to) continue;
			const ways = waysOf(track, from, to);
			if (ways.length === 0) break;
			behindIt.unshift(...ways);
			length += sum(ways);
		}
		if (length < TAIL) {
			const more = only(track, behindIt[0]?.edge.start ?? mark.barcode, TAIL - length);
			behindIt.unshift(...more);
			length += sum(more);
		}
		const next = this.marks[this.index + 1];
		let on = next && next.barcode !== mark.barcode ? waysOf(track, mark.barcode, next.barcode) : [];
		if (next && sum(on) > FASTEST$1 * Math.max(next.at - mark.at, LEAP)) on = [];
		this.ways = [...behindIt, ...on];
		this.offset = length;
		this.length = sum(on);
	}
};
/** How much of the way to the next mark was behind it. */
function share(mark, next, at) {
	const left = mark.moves ? mark.at : Math.max(mark.at, next.at - LEAP);
	return Math.min(Math.max((at - left) / Math.max(next.at - left, .001), 0), 1);
}
function sum(ways) {
	return ways.reduce((length, way) => length + way.edge.length, 0);
}
function waysOf(track, from, to) {
	if (!from || !to) return [];
	const direct = track.way(from, to);
	if (direct) return [direct];
	const path = track.path(from, to, 12) ?? [];
	return path.slice(1).flatMap((end, i) => track.way(path[i], end) ?? []);
}
/** The ways to a barcode for so many mm, as long as there is only one to have come. */
function only(track, barcode, mm) {
	const ways = [];
	for (let here = barcode, length = 0; length < mm;) {
		const [edge, other] = track.before.get(here) ?? [];
		const way = edge && !other ? track.way(edge.start, here) : void 0;
		if (!edge || !way || ways.includes(way)) break;
		ways.unshift(way);
		length += edge.length;
		here = edge.start;
	}
	return ways;
}
function place(track, ways, mm) {
	const first = ways[0];
	if (!first) return null;
	if (mm < 0) return behind(track.along(first, 0), -mm);
	let left = mm;
	for (const way of ways) {
		if (left <= way.edge.length) return track.along(way, left);
		left -= way.edge.length;
	}
	return track.along(ways.at(-1), Number.POSITIVE_INFINITY);
}
function rest(track, barcode, back) {
	const spot = track.spot(barcode);
	return spot ? behind(spot, back) : null;
}
/** The courses of all vehicles, as far as the recording was fetched. */
var Trails = class {
	courses = /* @__PURE__ */ new Map();
	seen = /* @__PURE__ */ new Map();
	clear() {
		this.courses.clear();
		this.seen.clear();
	}
	whole(at, state) {
		for (const [id, vehicle] of Object.entries(state["vehicles"] ?? {})) this.take(at, id, vehicle);
	}
	change([at, topic, key, value]) {
		if (topic === "vehicles") this.take(at, key, value ?? { barcode: null });
	}
	trim(before) {
		for (const course of this.courses.values()) course.trim(before);
	}
	/** Where the point lies that is `back` mm behind a vehicle's front at a moment; `still`: at its barcode. */
	spot(track, id, at, back, still = false) {
		return this.courses.get(id)?.spot(track, at, back, still) ?? null;
	}
	take(at, id, value) {
		if (!("barcode" in value) && !("activity" in value)) return;
		const seen = {
			...this.seen.get(id) ?? {
				barcode: null,
				activity: ""
			},
			...value
		};
		this.seen.set(id, {
			barcode: seen.barcode,
			activity: seen.activity
		});
		let course = this.courses.get(id);
		if (!course) this.courses.set(id, course = new Course());
		course.add({
			at,
			barcode: seen.barcode,
			moves: seen.activity === "moving"
		});
	}
};
// src/past/player.ts
/** Plays back what was recorded: which moment is shown, how fast it goes on, and that the pieces ahead are there in time. */
var PACES = [
	1,
	2,
	4,
	8,
	16
];
/** The moment that is shown, UTC seconds; 0: none yet. */
var moment = y$1(0);
/** The same as lists and fields tell it: they follow only some times a second, since the map wants the time. */
var told = y$1(0);
var playing = y$1(false);
var pace = y$1(1);
/** From when to when something was recorded; null: that is not known yet, or nothing was. */
var kept$1 = y$1(null);
/** The recording of the moment is being fetched. */
var loading = y$1(false);
/** It is known from when to when something was recorded, or that nothing was. */
var looked = y$1(false);
var error = y$1(null);
var trails = new Trails();
/** Pieces are fetched so far ahead: seconds of the viewer's time. */
var AHEAD = 12;
/** So much is fetched at once, seconds of the viewer's time. */
var PORTION = 10;
/** A moment that was asked for is fetched with so many seconds after it: the rest follows once it is shown. */
var FIRST = 2;
/** What was fetched is gone on with rather than begun anew for so many seconds beyond it. */
var BEYOND = 30;
/** What the lists and panels show follows so often, ms. */
var SHOWN$2 = 100;
/** How often lists and fields follow while it plays, ms. */
var TOLD = 250;
/** Nobody looks at a page that was not painted for longer, ms. */
var LONGEST = 250;
/** Whether more was recorded is asked so often, ms. */
var AGAIN = 5e3;
/** Who opens the room without naming a moment sees what was so long ago, s. */
var AT_FIRST = 60;
var reel = new Reel();
var screen = {
	whole: showWhole,
	change: showChange
};
var round = 0;
var fetching = false;
var wanted$1 = null;
var frame = 0;
var last = 0;
var flushed = 0;
var toldAt = 0;
var timer = 0;
var iso$2 = (seconds) => (/* @__PURE__ */ new Date(seconds * 1e3)).toISOString();
/** Ask from when to when there is something. */
async function look() {
	try {
		const span = await get("/history/span");
		const found = span.from && span.to ? {
			from: Date.parse(span.from) / 1e3,
			to: Date.parse(span.to) / 1e3,
			incident: span.incident
		} : null;
		if (JSON.stringify(found) !== JSON.stringify(kept$1.value)) kept$1.value = found;
		looked.value = true;
		error.value = null;
	} catch (failure) {
		error.value = failure;
	}
}
/** Fetch pieces from a moment on, or those after the last one. */
async function fetchOn(from, to, mine) {
	const query = new URLSearchParams({
		from: iso$2(from),
		to: iso$2(Math.max(to, from + .001))
	});
	if (reel.last !== null) query.set("after", String(reel.last));
	const body = await bytes(`/history/pieces?${query}`);
	if (mine !== round) return;
	for await (const piece of piecesOf(body)) {
		if (mine !== round) return;
		if (piece.state) trails.whole(piece.begin, piece.state);
		for (const change of piece.changes ?? []) trails.change(change);
		reel.add(piece);
	}
	if (!headOf(body).head.more) reel.until = Math.max(reel.until, to);
	trails.trim(reel.trim());
}
/** Fetch what will be shown soon, if it is not here. */
async function feed() {
	const span = kept$1.value;
	if (fetching || !span || wanted$1 !== null || reel.last === null) return;
	const need = Math.min(moment.value + AHEAD * pace.value, span.to);
	if (reel.until >= need) return;
	fetching = true;
	try {
		await fetchOn(reel.until, Math.min(Math.max(need, reel.until + PORTION * pace.value), span.to), round);
		error.value = null;
	} catch (failure) {
		error.value = failure;
		pause();
	} finally {
		fetching = false;
	}
}
/** Show a moment. While it is being fetched another may be asked for: then that one is shown next. */
async function seek(at) {
	const span = kept$1.value;
	if (!span) return;
	const goal = Math.min(Math.max(at, span.from), span.to);
	moment.value = goal;
	if (reel.holds(goal) && wanted$1 === null) {
		reel.seek(goal, screen);
		shown();
		settle();
		feed();
		return;
	}
	const busy = wanted$1 !== null;
	wanted$1 = goal;
	if (!busy) await load$1();
}
async function load$1() {
	loading.value = true;
	try {
		for (let at = wanted$1; at !== null; at = wanted$1 === at ? null : wanted$1) {
			const mine = ++round;
			if (at < reel.begin || at > reel.until + BEYOND) {
				reel.clear();
				trails.clear();
			}
			const end = Math.min(at + FIRST, kept$1.value?.to ?? at);
			for (let first = true; first || reel.last !== null && reel.until < at; first = false) await fetchOn(at, end, mine);
			if (mine !== round) return;
			if (reel.begin > at) moment.value = Math.min(reel.begin, kept$1.value?.to ?? reel.begin);
			reel.seek(moment.value, screen);
			shown();
		}
		error.value = null;
	} catch (failure) {
		error.value = failure;
		playing.value = false;
	} finally {
		wanted$1 = null;
		loading.value = false;
		settle();
	}
	feed();
}
/** Where it stands still, the address names the moment. */
function settle() {
	if (!playing.value && room$1.value === "playback" && moment.value > 0) momentShown.value = iso$2(moment.value);
}
function pause() {
	playing.value = false;
	cancelAnimationFrame(frame);
	if (reel.last !== null) {
		reel.forward(moment.value, screen);
		shown();
	}
	settle();
}
function play() {
	const span = kept$1.value;
	if (!span || playing.value) return;
	if (moment.value >= span.to) seek(span.from);
	playing.value = true;
	last = performance.now();
	frame = requestAnimationFrame(turn);
}
function turn(now) {
	if (!playing.value) return;
	frame = requestAnimationFrame(turn);
	const took = Math.min(now - last, LONGEST) / 1e3;
	last = now;
	feed();
	if (loading.value || reel.last === null) return;
	const end = kept$1.value?.to ?? 0;
	const next = moment.value + took * pace.value;
	moment.value = Math.min(next, reel.until, end);
	if (now - flushed >= SHOWN$2) {
		flushed = now;
		reel.forward(moment.value, screen);
		shown();
	}
	if (moment.value >= end) pause();
}
async function enter() {
	lookBack();
	const mine = ++round;
	await look();
	if (mine !== round || room$1.value !== "playback") return;
	window.clearInterval(timer);
	if (!kept$1.value?.incident) timer = window.setInterval(() => void lookAgain(), AGAIN);
	await show$1();
}
/** Whether more was recorded; who found nothing at first is shown what there is now. */
async function lookAgain() {
	await look();
	if (moment.value === 0 && wanted$1 === null && room$1.value === "playback") await show$1();
}
/** Show the moment that was asked for, or one shortly ago. */
async function show$1() {
	if (!kept$1.value) return;
	const asked = momentAsked.value === null ? NaN : Date.parse(momentAsked.value) / 1e3;
	const first = kept$1.value.incident ? kept$1.value.from : kept$1.value.to - AT_FIRST;
	await seek(Number.isNaN(asked) ? first : asked);
}
function leave() {
	round++;
	window.clearInterval(timer);
	cancelAnimationFrame(frame);
	playing.value = false;
	wanted$1 = null;
	moment.value = 0;
	looked.value = false;
	momentShown.value = momentAsked.value = null;
	reel.clear();
	trails.clear();
	backToNow();
}
/** Follow the room: whoever opens playback sees the past, whoever leaves it the present. A recorded incident has nothing else. */
function begin$2() {
	forbidWhile(() => inPast.value ? t("past_no_commands") : "");
	x(() => {
		const at = moment.value;
		const now = performance.now();
		if (playing.value && now - toldAt < TOLD) return;
		toldAt = now;
		told.value = at;
	});
	let inside = false;
	x(() => {
		const now = room$1.value === "playback";
		if (now === inside) return;
		inside = now;
		queueMicrotask(() => now ? void enter() : leave());
	});
	x(() => {
		if (recording.value) room$1.value = "playback";
	});
	momentAsked.subscribe((asked) => {
		if (asked !== null && inside && kept$1.value && asked !== momentShown.peek()) seek(Date.parse(asked) / 1e3);
	});
}
// src/parts/Jobs.tsx
/** Jobs, newest first: what each does, or why it waits. */
var SHOWN$1 = 100;
var CANCELLABLE = /* @__PURE__ */ new Set(["queued", "waiting"]);
var ABORTABLE = /* @__PURE__ */ new Set(["transferring", "paused"]);
function Jobs() {
	const which = useSignal("all");
	const error = useSignal(null);
	tick.value;
	const all = jobList.value;
	const open = all.filter((job) => !ENDED.has(job.state));
	const list = which.value === "open" ? open : which.value === "ended" ? all.filter((job) => ENDED.has(job.state)) : all;
	const ask = (job, what) => {
		error.value = null;
		post(`/jobs/${encodeURIComponent(job.id)}/${what}`).catch((failure) => error.value = failure);
	};
	return /* @__PURE__ */ a("section", {
		class: "card jobs",
		children: [
			/* @__PURE__ */ a("h2", { children: [t("jobs"), /* @__PURE__ */ a("span", {
				class: "tabs",
				children: [
					"all",
					"open",
					"ended"
				].map((tab) => /* @__PURE__ */ a("button", {
					type: "button",
					"aria-pressed": which.value === tab,
					onClick: () => which.value = tab,
					children: [t(tab), tab === "open" && ` ${counted(open.length)}`]
				}, tab))
			})] }),
			/* @__PURE__ */ a(Problem, { error: error.value }),
			/* @__PURE__ */ a("ul", {
				class: "scroll",
				children: [list.length === 0 && /* @__PURE__ */ a("li", {
					class: "nothing",
					children: none(t("no_jobs"))
				}), list.slice(0, SHOWN$1).map((job) => /* @__PURE__ */ a(Row, {
					job,
					ask
				}, job.id))]
			})
		]
	});
}
function Row({ job, ask }) {
	const over = ENDED.has(job.state);
	const why = over ? job.result || job.reason : job.reason || leg(job);
	return /* @__PURE__ */ a("li", {
		class: over ? "job over" : "job",
		"data-job": job.id,
		children: [
			/* @__PURE__ */ a("span", {
				class: `state ${TONES$2[job.state] ?? "calm"}`,
				children: said$1(job.state)
			}),
			/* @__PURE__ */ a("span", {
				class: "facts",
				children: [
					/* @__PURE__ */ a("button", {
						type: "button",
						class: "text",
						title: t("job_details"),
						onClick: () => selected.value = {
							kind: "job",
							id: job.id
						},
						children: job.id
					}),
					job.priority !== 50 && /* @__PURE__ */ a("span", {
						title: t("priority"),
						children: ["P", job.priority]
					}),
					job.carrier && /* @__PURE__ */ a("span", { children: job.carrier }),
					job.vehicle && /* @__PURE__ */ a("button", {
						type: "button",
						class: "text",
						onClick: () => selected.value = {
							kind: "vehicle",
							id: job.vehicle
						},
						children: job.vehicle
					})
				]
			}),
			/* @__PURE__ */ a("span", {
				class: "age",
				children: elapsed(job, inPast.value ? told.value * 1e3 : serverNow())
			}),
			/* @__PURE__ */ a("span", {
				class: "route",
				children: [
					/* @__PURE__ */ a(Place$1, { id: job.source }),
					/* @__PURE__ */ a("i", { children: "→" }),
					/* @__PURE__ */ a(Place$1, { id: job.destination })
				]
			}),
			/* @__PURE__ */ a("span", {
				class: "act",
				children: [!inPast.value && CANCELLABLE.has(job.state) && /* @__PURE__ */ a(Sure, {
					needs: "POST /jobs/{job}/cancel",
					label: t("cancel"),
					does: () => ask(job, "cancel")
				}), !inPast.value && ABORTABLE.has(job.state) && /* @__PURE__ */ a(Sure, {
					needs: "POST /jobs/{job}/abort",
					label: t("abort"),
					does: () => ask(job, "abort")
				})]
			}),
			/* @__PURE__ */ a("span", {
				class: "reason",
				title: tell(why),
				children: tell(why)
			})
		]
	});
}
function leg(job) {
	const waiting = job.vehicle ? vehicles.get(job.vehicle)?.waiting : "";
	if (waiting) return waiting;
	if (job.leg === "to_source") return `${job.vehicle} → ${job.source}`;
	if (job.leg === "to_destination") return `${job.vehicle} → ${job.destination}`;
	return job.leg === "none" ? "" : `${job.vehicle}: ${said$1(job.leg)}`;
}
function Place$1({ id }) {
	const kind = vehicles.has(id) ? "vehicle" : "station";
	return /* @__PURE__ */ a("button", {
		type: "button",
		class: "text",
		onClick: () => selected.value = {
			kind,
			id
		},
		children: id
	});
}
// src/versions.ts
var HOW = {
	added: "added",
	removed: "removed",
	changed: "changed",
	moved: "changed",
	renamed: "changed"
};
var ROOM = .04;
function field(value, name) {
	return value !== null && typeof value === "object" ? value[name] : void 0;
}
/** Lay a difference over the plan that runs: track and marks, each as it is, comes, goes or changes. */
function drawn(layout, changes) {
	const spots = new Map(layout.points.map((point) => [point.barcode, [point.x, point.y]]));
	const marks = [];
	for (const change of changes.filter(({ what }) => what === "barcode")) {
		const [x, y] = [field(change.after, "x"), field(change.after, "y")];
		const moved = change.how === "moved" ? change.after : null;
		const at = x !== void 0 && y !== void 0 ? [x, y] : moved ? [moved[0], moved[1]] : spots.get(change.name);
		if (!at) continue;
		if (change.how === "added") spots.set(change.name, at);
		if (change.how === "renamed" && typeof change.after === "string") spots.set(change.after, at);
		marks.push({
			at,
			how: HOW[change.how],
			name: change.name,
			station: false
		});
	}
	for (const change of changes.filter(({ what }) => what === "station")) {
		const barcode = field(change.after, "barcode") ?? field(change.before, "barcode");
		const at = barcode === void 0 ? void 0 : spots.get(barcode);
		if (at) marks.push({
			at,
			how: HOW[change.how],
			name: change.name,
			station: true
		});
	}
	return {
		track: trackOf(layout, changes, spots),
		marks,
		box: boxOf$2([...spots.values()])
	};
}
function trackOf(layout, changes, spots) {
	const pieces = {
		same: [],
		added: [],
		removed: [],
		changed: []
	};
	const draw = (how, start, end) => {
		const [from, to] = [spots.get(start), spots.get(end)];
		if (from && to) pieces[how].push(`M${from[0]} ${from[1]}L${to[0]} ${to[1]}`);
	};
	const other = /* @__PURE__ */ new Set();
	for (const change of changes.filter(({ what }) => what === "track")) {
		const edge = change.after ?? change.before;
		const [start, end] = [field(edge, "start") ?? "", field(edge, "end") ?? ""];
		other.add(`${start} ${end}`);
		draw(HOW[change.how], start, end);
	}
	for (const { start, end } of layout.edges) if (!other.has(`${start} ${end}`)) draw("same", start, end);
	return {
		same: pieces.same.join(""),
		added: pieces.added.join(""),
		removed: pieces.removed.join(""),
		changed: pieces.changed.join("")
	};
}
function boxOf$2(spots) {
	let [left, top, right, bottom] = [
		Infinity,
		Infinity,
		-Infinity,
		-Infinity
	];
	for (const [x, y] of spots) {
		left = Math.min(left, x);
		right = Math.max(right, x);
		top = Math.min(top, y);
		bottom = Math.max(bottom, y);
	}
	if (spots.length === 0) return {
		x: 0,
		y: 0,
		width: 1,
		height: 1
	};
	const room = Math.max(right - left, bottom - top, 1) * ROOM;
	return {
		x: left - room,
		y: top - room,
		width: right - left + 2 * room,
		height: bottom - top + 2 * room
	};
}
// src/parts/DifferenceMap.tsx
/** The plan that runs with a difference laid over it: what comes, goes and changes, told apart by colour, line and sign. */
var SIGN = {
	same: "",
	added: "+",
	removed: "−",
	changed: "~"
};
var SHOWN = [
	"same",
	"changed",
	"removed",
	"added"
];
function DifferenceMap({ changes }) {
	if (!layout.value) return null;
	const { track, marks, box } = drawn(layout.value, changes);
	const unit = Math.max(box.width, box.height) / 100;
	return /* @__PURE__ */ a("figure", {
		class: "difference",
		children: [/* @__PURE__ */ a("svg", {
			viewBox: `${box.x} ${box.y} ${box.width} ${box.height}`,
			role: "img",
			"aria-label": t("what_differs"),
			children: [SHOWN.map((how) => /* @__PURE__ */ a("path", {
				d: track[how],
				class: `track ${how}`,
				"vector-effect": "non-scaling-stroke"
			}, how)), marks.map((mark) => /* @__PURE__ */ a("g", {
				class: mark.how,
				"data-mark": mark.name,
				children: [mark.station ? /* @__PURE__ */ a("rect", {
					x: mark.at[0] - unit * .8,
					y: mark.at[1] - unit * .8,
					width: unit * 1.6,
					height: unit * 1.6
				}) : /* @__PURE__ */ a("circle", {
					cx: mark.at[0],
					cy: mark.at[1],
					r: unit * .6
				}), /* @__PURE__ */ a("text", {
					x: mark.at[0] + unit,
					y: mark.at[1] - unit * .7,
					"font-size": unit * 2,
					children: [
						SIGN[mark.how],
						" ",
						mark.name
					]
				})]
			}, `${mark.station} ${mark.name} ${mark.how}`))]
		}), /* @__PURE__ */ a("figcaption", { children: [
			"added",
			"removed",
			"changed"
		].map((how) => /* @__PURE__ */ a("span", {
			class: how,
			children: [
				SIGN[how],
				" ",
				t(`diff_${how}`)
			]
		}, how)) })]
	});
}
// src/parts/Layouts.tsx
/** Versions of the plant: stage a file, see what differs and what it breaks, activate it, roll back. */
/** Asked so often, s. */
var EVERY$3 = 2;
var TONE = {
	staged: "",
	awaited: "wait",
	active: "good",
	former: "calm",
	rejected: "bad"
};
function Layouts() {
	const chosen = useSignal(null);
	const again = useSignal(0);
	const { value, error } = useRead("/layout/versions?limit=200", again.value, Math.floor(tick.value / EVERY$3));
	const items = value?.items ?? [];
	const active = items.find(({ state }) => state === "active");
	const version = items.find(({ number }) => number === chosen.value);
	A$1(() => {
		if (active && layout.value && layout.value.version !== active.number) location.reload();
	}, [active?.number]);
	return /* @__PURE__ */ a("section", {
		class: "room",
		"aria-label": t("layouts"),
		children: [/* @__PURE__ */ a("div", {
			class: "head",
			children: /* @__PURE__ */ a("h2", { children: t("layouts") })
		}), /* @__PURE__ */ a("div", {
			class: "split layouts",
			children: [
				/* @__PURE__ */ a("div", { children: [
					/* @__PURE__ */ a(Table, {
						label: t("layouts"),
						rows: items,
						keyOf: (row) => String(row.number),
						pick: (row) => chosen.value = row.number,
						chosen: String(chosen.value),
						none: t("no_versions"),
						columns: [
							{
								name: "#",
								by: (row) => row.number,
								of: (row) => /* @__PURE__ */ a(Chosen, {
									version: row,
									pick: () => chosen.value = row.number
								}),
								number: true
							},
							{
								name: t("state"),
								by: (row) => row.state,
								of: (row) => /* @__PURE__ */ a("b", {
									class: TONE[row.state],
									children: t(`version_${row.state}`)
								})
							},
							{
								name: t("at"),
								by: (row) => row.activated ?? row.at,
								of: (row) => moment$1(row.activated ?? row.at)
							},
							{
								name: t("actor"),
								by: (row) => row.activated_by ?? row.actor,
								of: (row) => tell(row.activated_by ?? row.actor)
							},
							{
								name: t("reason"),
								wraps: true,
								of: (row) => tell(row.why || row.reason)
							}
						]
					}),
					/* @__PURE__ */ a(Problem, { error }),
					/* @__PURE__ */ a(Stage$1, { after: (number) => {
						chosen.value = number;
						again.value++;
					} })
				] }),
				!version && /* @__PURE__ */ a("p", {
					class: "nothing",
					children: none(t("choose_version"))
				}),
				version && /* @__PURE__ */ a(Detail$2, {
					version,
					active: active ?? null,
					after: () => again.value++
				}, version.number)
			]
		})]
	});
}
function Chosen({ version, pick }) {
	return /* @__PURE__ */ a("button", {
		type: "button",
		class: "text",
		onClick: pick,
		children: version.number
	});
}
function Stage$1({ after }) {
	const reason = useSignal("");
	const file = useSignal(null);
	const findings = useSignal([]);
	const asking = useAsking();
	const send = async (event) => {
		event.preventDefault();
		findings.value = [];
		await asking.ask(async () => {
			const text = await file.value.text();
			const made = await upload(`/layout/versions?${new URLSearchParams({ reason: reason.value.trim() })}`, text, "application/yaml");
			findings.value = made.findings;
			file.value = null;
			reason.value = "";
			after(made.number);
		}, t("version_taken"));
		if (asking.error.value instanceof Refused) findings.value = asking.error.value.errors;
	};
	return /* @__PURE__ */ a("form", {
		class: "stack padded",
		"aria-label": t("stage_file"),
		onSubmit: (event) => void send(event),
		children: [
			/* @__PURE__ */ a("h2", {
				class: "sub",
				children: t("stage_file")
			}),
			/* @__PURE__ */ a("div", {
				class: "acts-row",
				children: /* @__PURE__ */ a("label", {
					class: "file",
					children: [/* @__PURE__ */ a("span", { children: file.value?.name ?? t("plant_file") }), /* @__PURE__ */ a("input", {
						type: "file",
						accept: ".yaml,.yml",
						"aria-label": t("plant_file"),
						onChange: (event) => file.value = event.currentTarget.files?.[0] ?? null
					})]
				})
			}),
			/* @__PURE__ */ a(Field, {
				label: t("reason"),
				name: "reason",
				value: reason,
				wide: true
			}),
			/* @__PURE__ */ a("div", {
				class: "acts-row",
				children: /* @__PURE__ */ a(Button, {
					needs: "POST /layout/versions",
					type: "submit",
					disabled: asking.busy.value || !file.value || !reason.value.trim(),
					children: t("stage_file")
				})
			}),
			/* @__PURE__ */ a(Told, { asking }),
			/* @__PURE__ */ a("ul", {
				class: "plain findings",
				children: findings.value.map((one) => /* @__PURE__ */ a("li", {
					class: one.severity === "error" ? "bad" : "wait",
					children: [
						one.line,
						":",
						one.column,
						" ",
						tell(one.message),
						one.remedy && /* @__PURE__ */ a("small", {
							class: "calm",
							children: [" ", tell(one.remedy)]
						})
					]
				}, `${one.line}:${one.column} ${one.message}`))
			})
		]
	});
}
function Detail$2({ version, active, after }) {
	const path = `/layout/versions/${version.number}`;
	const compared = !(version.state === "active") && !version.pruned;
	const change = useRead(compared ? `${path}/diff` : null, active?.number);
	const impact = useRead(compared ? `${path}/impact` : null, active?.number, Math.floor(tick.value / EVERY$3));
	const asking = useAsking();
	const activate = (wait) => async (reason) => {
		await post(`${path}/activate`, {
			reason,
			wait,
			instead_of: active?.number ?? null
		});
		after();
	};
	const reject = async (reason) => {
		await post(`${path}/reject`, { reason });
		after();
	};
	const label = version.state === "former" ? t("roll_back_to") : t("activate");
	const ready = impact.value?.ready ?? false;
	const decisions = [{
		label,
		needs: "POST /layout/versions/{version}/activate",
		grave: true,
		does: activate(false)
	}, ...ready ? [] : [{
		label: t("activate_later"),
		needs: "POST /layout/versions/{version}/activate",
		grave: true,
		does: activate(true)
	}]];
	const rejecting = {
		label: t(version.state === "awaited" ? "take_back" : "reject"),
		needs: "POST /layout/versions/{version}/reject",
		does: reject
	};
	const open = version.state === "staged" || version.state === "former";
	return /* @__PURE__ */ a("section", {
		class: "stack padded",
		"data-version": version.number,
		"aria-label": `${t("version")} ${version.number}`,
		children: [
			/* @__PURE__ */ a("h2", {
				class: "sub",
				children: [
					t("version"),
					" ",
					version.number,
					" · ",
					/* @__PURE__ */ a("b", {
						class: TONE[version.state],
						children: t(`version_${version.state}`)
					})
				]
			}),
			/* @__PURE__ */ a("p", { children: [
				version.actor,
				" · ",
				moment$1(version.at),
				" · ",
				version.reason
			] }),
			version.note && /* @__PURE__ */ a("p", {
				class: "note held",
				children: tell(version.note)
			}),
			version.pruned && /* @__PURE__ */ a("p", {
				class: "note",
				children: t("text_not_kept")
			}),
			version.state === "awaited" && /* @__PURE__ */ a("p", {
				class: "note",
				children: t("jobs_refused_meanwhile")
			}),
			!version.pruned && /* @__PURE__ */ a("div", {
				class: "acts-row",
				children: /* @__PURE__ */ a("button", {
					type: "button",
					onClick: () => void asking.ask(() => download(`${path}/file`, `${layout.value?.name ?? "plant"}-${version.number}.yaml`), ""),
					children: t("save_file")
				})
			}),
			/* @__PURE__ */ a(Told, { asking }),
			open && /* @__PURE__ */ a(Reasoned, { decisions: version.state === "staged" ? [...decisions, rejecting] : decisions }),
			version.state === "awaited" && /* @__PURE__ */ a(Reasoned, { decisions: [rejecting] }),
			compared && /* @__PURE__ */ a(Weighed, {
				impact: impact.value,
				error: impact.error
			}),
			compared && /* @__PURE__ */ a(Changes$1, {
				difference: change.value,
				error: change.error
			})
		]
	});
}
function Weighed({ impact, error }) {
	if (!impact) return /* @__PURE__ */ a(Problem, { error });
	return /* @__PURE__ */ a($, { children: [
		/* @__PURE__ */ a("h3", { children: t("in_the_way") }),
		impact.ready ? /* @__PURE__ */ a("p", {
			class: "good",
			children: t("nothing_in_the_way")
		}) : /* @__PURE__ */ a(Breaks, {
			list: impact.in_the_way,
			tone: "bad"
		}),
		impact.lost.length > 0 && /* @__PURE__ */ a("h3", { children: t("lost_with_it") }),
		/* @__PURE__ */ a(Breaks, {
			list: impact.lost,
			tone: "wait"
		}),
		impact.lacking.length > 0 && /* @__PURE__ */ a("h3", { children: t("lacking_with_it") }),
		/* @__PURE__ */ a(Breaks, {
			list: impact.lacking,
			tone: "wait"
		})
	] });
}
function Breaks({ list, tone }) {
	return /* @__PURE__ */ a("ul", {
		class: "plain findings",
		children: list.map((one) => /* @__PURE__ */ a("li", { children: [
			/* @__PURE__ */ a("b", {
				class: tone,
				children: [
					said$1(one.what),
					" ",
					one.name
				]
			}),
			": ",
			tell(one.text),
			one.remedy && /* @__PURE__ */ a("small", {
				class: "calm",
				children: [" ", tell(one.remedy)]
			})
		] }, `${one.what} ${one.name} ${one.text}`))
	});
}
function Changes$1({ difference, error }) {
	if (!difference) return /* @__PURE__ */ a(Problem, { error });
	const keyOf = (row) => `${row.what} ${row.name} ${row.how} ${row.text}`;
	return /* @__PURE__ */ a($, { children: [
		/* @__PURE__ */ a("h3", { children: [
			t("what_differs"),
			" ",
			difference.against,
			" → ",
			difference.version
		] }),
		difference.changes.length > 0 && /* @__PURE__ */ a(DifferenceMap, { changes: difference.changes }),
		/* @__PURE__ */ a(Table, {
			label: t("what_differs"),
			rows: difference.changes,
			keyOf,
			none: t("no_difference"),
			columns: [
				{
					name: t("what"),
					by: (row) => row.what,
					of: (row) => said$1(row.what)
				},
				{
					name: t("name"),
					by: (row) => row.name,
					of: (row) => row.name
				},
				{
					name: t("how"),
					by: (row) => row.how,
					of: (row) => /* @__PURE__ */ a("b", {
						class: `how ${row.how}`,
						children: t(`diff_${row.how}`)
					})
				},
				{
					name: t("in_words"),
					wraps: true,
					of: (row) => tell(row.text)
				}
			]
		}),
		/* @__PURE__ */ a(Breaks, {
			list: difference.breaks,
			tone: "wait"
		})
	] });
}
// src/parts/LogIn.tsx
/** Asks who is there: name and password, or a machine's key. What stands on the page behind it stays as it was. */
function LogIn() {
	const byKey = useSignal(false);
	const name = useSignal(me.value?.person ? me.value.name ?? "" : "");
	const secret = useSignal("");
	const box = T(null);
	const asking = useAsking();
	const again = me.value !== null && !me.value.open;
	A$1(() => box.current?.showModal(), []);
	const enter = async (event) => {
		event.preventDefault();
		const given = secret.value;
		if (!await asking.ask(() => byKey.value ? useKey(given.trim()) : logIn(name.value.trim(), given), "")) secret.value = "";
	};
	const other = () => {
		byKey.value = !byKey.value;
		secret.value = "";
		asking.error.value = null;
	};
	return /* @__PURE__ */ a("dialog", {
		ref: box,
		"aria-label": t("log_in"),
		onCancel: (event) => event.preventDefault(),
		children: /* @__PURE__ */ a("form", {
			onSubmit: (event) => void enter(event),
			children: [
				/* @__PURE__ */ a("h2", { children: t(again ? "log_in_again" : byKey.value ? "key_title" : "log_in_title") }),
				again && /* @__PURE__ */ a("p", { children: t("nothing_lost") }),
				!byKey.value && /* @__PURE__ */ a("label", { children: [/* @__PURE__ */ a("span", { children: t("name") }), /* @__PURE__ */ a("input", {
					name: "name",
					required: true,
					maxLength: 64,
					autocomplete: "username",
					value: name.value,
					onInput: (event) => name.value = event.currentTarget.value
				})] }),
				/* @__PURE__ */ a("label", { children: [/* @__PURE__ */ a("span", { children: t(byKey.value ? "key_label" : "password") }), /* @__PURE__ */ a("input", {
					name: byKey.value ? "key" : "password",
					type: "password",
					required: true,
					autocomplete: byKey.value ? "off" : "current-password",
					value: secret.value,
					onInput: (event) => secret.value = event.currentTarget.value
				})] }, String(byKey.value)),
				byKey.value && /* @__PURE__ */ a("p", { children: t("key_hint") }),
				/* @__PURE__ */ a(Told, { asking }),
				/* @__PURE__ */ a("div", {
					class: "acts-row",
					children: [/* @__PURE__ */ a("button", {
						type: "submit",
						class: "primary",
						disabled: asking.busy.value,
						children: t(byKey.value ? "key_use" : "log_in")
					}), /* @__PURE__ */ a("button", {
						type: "button",
						class: "text",
						onClick: other,
						children: t(byKey.value ? "use_password" : "use_a_key")
					})]
				})
			]
		})
	});
}
// src/parts/Ordering.tsx
/**
* Where the order form is on a narrow screen: beside the map as everywhere; in another room its table needs the width, and the form
* lies over it when somebody opens it. The style sheet shows these buttons where there is no room beside the table.
*/
var OPENER = "open-ordering";
var ordering = y$1(false);
/** Another room, or something that was chosen: the form has done its work. */
x(() => {
	room$1.value;
	selected.value;
	ordering.value = false;
});
function close() {
	ordering.value = false;
	document.getElementById(OPENER)?.focus();
}
function open() {
	ordering.value = true;
	requestAnimationFrame(() => document.querySelector("#ordering select")?.focus());
}
function OpenOrder() {
	if (room$1.value === "map" || selected.value) return null;
	return /* @__PURE__ */ a("button", {
		type: "button",
		id: OPENER,
		class: "opens-order",
		"aria-expanded": ordering.value,
		"aria-controls": "ordering",
		onClick: () => ordering.value ? close() : open(),
		children: t("new_transfer")
	});
}
/** At the top of what lies over the table; Escape does the same from anywhere in it. */
function CloseOrder() {
	if (!ordering.value) return null;
	return /* @__PURE__ */ a("div", {
		class: "closes-order",
		children: /* @__PURE__ */ a("button", {
			type: "button",
			onClick: close,
			children: t("close")
		})
	});
}
document.addEventListener("keydown", (event) => {
	if (event.key === "Escape" && ordering.value && !event.defaultPrevented && !document.querySelector("dialog[open]")) close();
});
// src/waiting.ts
/** The vehicle at the end of a chain of waits, which does not wait for another itself; null: this one waits for none, or in a circle. */
function rootOf(vehicle, find) {
	const seen = /* @__PURE__ */ new Set([vehicle.id]);
	let here = vehicle;
	for (let next = here.waits_for; next; next = here.waits_for) {
		const other = find(next);
		if (!other || seen.has(next)) return null;
		seen.add(next);
		here = other;
	}
	return here === vehicle ? null : here;
}
// src/parts/ByHand.tsx
/** A new version of a port's DEST or a vehicle's OFFSET, written by hand: only if nobody else wrote one meanwhile. */
var AXES$1 = [
	"shft",
	"rota",
	"lift"
];
function ByHand({ kind, path, newest, after }) {
	const values = {
		shft: useSignal(String(newest?.shft ?? "")),
		rota: useSignal(String(newest?.rota ?? "")),
		lift: useSignal(String(newest?.lift ?? ""))
	};
	const asking = useAsking();
	const whole = AXES$1.every((axis) => /^-?\d+$/.test(values[axis].value.trim()));
	const write = async () => {
		const body = Object.fromEntries(AXES$1.map((axis) => [axis, Number(values[axis].value)]));
		const match = newest ? { "If-Match": `"${newest.version}"` } : {};
		if (await asking.ask(() => call("PUT", path, body, match))) after();
	};
	return /* @__PURE__ */ a("details", { children: [/* @__PURE__ */ a("summary", { children: t("write_by_hand") }), /* @__PURE__ */ a("div", {
		class: "stack",
		children: [
			/* @__PURE__ */ a("div", {
				class: "fields three",
				children: AXES$1.map((axis) => /* @__PURE__ */ a(Field, {
					label: axis.toUpperCase(),
					name: axis,
					type: "number",
					value: values[axis]
				}, axis))
			}),
			/* @__PURE__ */ a("div", {
				class: "acts-row",
				children: /* @__PURE__ */ a(Sure, {
					needs: kind === "station" ? "PUT /stations/{station}/dest" : "PUT /vehicles/{vehicle}/offset",
					label: t("write"),
					disabled: !whole,
					does: () => void write()
				})
			}),
			/* @__PURE__ */ a(Told, { asking })
		]
	})] });
}
// src/parts/Pulses.tsx
/** Positions of the three taught axes, and what changes for whom. */
var AXES = [
	"shft",
	"rota",
	"lift"
];
function Pulses({ axes, signed, before }) {
	if (!axes) return /* @__PURE__ */ a($, { children: "–" });
	const text = (value) => value === null ? "–" : signed && value > 0 ? `+${value}` : String(value);
	return /* @__PURE__ */ a("span", {
		class: "pulses",
		children: AXES.map((axis) => /* @__PURE__ */ a("span", {
			class: before && before[axis] !== axes[axis] ? "changed" : "",
			title: axis.toUpperCase(),
			children: text(axes[axis])
		}, axis))
	});
}
function Changes({ changes }) {
	if (changes.length === 0) return /* @__PURE__ */ a("p", {
		class: "calm",
		children: t("changes_nothing")
	});
	return /* @__PURE__ */ a("table", {
		class: "list changes",
		children: [/* @__PURE__ */ a("thead", { children: /* @__PURE__ */ a("tr", { children: [
			t("at_station"),
			t("vehicle"),
			t("old"),
			t("new"),
			""
		].map((name) => /* @__PURE__ */ a("th", { children: /* @__PURE__ */ a("span", { children: name }) }, name)) }) }), /* @__PURE__ */ a("tbody", { children: changes.slice(0, 60).map((change) => /* @__PURE__ */ a("tr", { children: [
			/* @__PURE__ */ a("td", { children: /* @__PURE__ */ a(Name, { id: change.station }) }),
			/* @__PURE__ */ a("td", { children: /* @__PURE__ */ a(Name, { id: change.vehicle }) }),
			/* @__PURE__ */ a("td", { children: /* @__PURE__ */ a(Pulses, { axes: change.old }) }),
			/* @__PURE__ */ a("td", { children: /* @__PURE__ */ a(Pulses, {
				axes: change.new,
				before: change.old
			}) }),
			/* @__PURE__ */ a("td", {
				class: "bad",
				children: change.beyond
			})
		] }, change.station + change.vehicle)) })]
	});
}
// src/parts/Taught.tsx
/** What a port or a vehicle was taught: versions with their origin, compared with each other, and rolled back. */
function Taught({ kind, id }) {
	const open = useSignal(false);
	return /* @__PURE__ */ a("details", {
		class: "part acts",
		open: open.value,
		onToggle: (event) => open.value = event.currentTarget.open,
		children: [/* @__PURE__ */ a("summary", { children: t(kind === "station" ? "dest" : "offset") }), open.value && /* @__PURE__ */ a(Versions, {
			kind,
			id
		})]
	});
}
function Versions({ kind, id }) {
	const name = encodeURIComponent(id);
	const path = kind === "station" ? `/stations/${name}/dest` : `/vehicles/${name}/offset`;
	const again = useSignal(0);
	const { value } = useRead(path, changes.teaching.value, changes.stations.value === 0, again.value);
	const old = useSignal(null);
	const asking = useAsking();
	const list = [...value?.items ?? []].reverse();
	const newest = list[0];
	if (!value) return null;
	const byHand = /* @__PURE__ */ a(ByHand, {
		kind,
		path,
		newest,
		after: () => again.value++
	}, newest?.version);
	if (!newest) return /* @__PURE__ */ a("div", {
		class: "stack",
		children: [/* @__PURE__ */ a("p", {
			class: "nothing",
			children: t("never_taught")
		}), byHand]
	});
	const compare = old.value !== null && old.value !== newest.version ? `/teaching/compare/${kind}s/${name}/${old.value}/${newest.version}` : null;
	return /* @__PURE__ */ a("div", {
		class: "stack",
		children: [
			/* @__PURE__ */ a("table", {
				class: "bits versions",
				children: /* @__PURE__ */ a("tbody", { children: list.map((version) => /* @__PURE__ */ a("tr", {
					"data-version": version.version,
					children: [
						/* @__PURE__ */ a("th", { children: ["v", version.version] }),
						/* @__PURE__ */ a("td", { children: /* @__PURE__ */ a(Pulses, { axes: version }) }),
						/* @__PURE__ */ a("td", { children: [
							tell(said$1(version.source)),
							" · ",
							version.actor,
							" · ",
							clock(version.at),
							version.restores !== null && ` · = v${version.restores}`,
							version.reason && ` · ${version.reason}`,
							version.basis.map((basis) => /* @__PURE__ */ a("small", {
								class: "basis",
								children: [
									basis.axis.toUpperCase(),
									" ",
									basis.raw,
									" − ",
									basis.less ?? 0,
									" (",
									basis.vehicle,
									" @ ",
									basis.barcode,
									")"
								]
							}, basis.axis)),
							version !== newest && /* @__PURE__ */ a("button", {
								type: "button",
								class: "text",
								onClick: () => old.value = version.version,
								children: t("compare")
							})
						] })
					]
				}, version.version)) })
			}),
			compare && /* @__PURE__ */ a(Compared, { path: compare }),
			compare && /* @__PURE__ */ a(Reasoned, {
				asking,
				decisions: [{
					label: t("roll_back", old.value ?? 0),
					needs: kind === "station" ? "POST /stations/{station}/dest/rollback" : "POST /vehicles/{vehicle}/offset/rollback",
					grave: true,
					does: async (reason) => {
						await post(`${path}/rollback`, {
							version: old.value,
							reason
						}, { "If-Match": `"${newest.version}"` });
						old.value = null;
						again.value++;
					}
				}]
			}),
			!compare && /* @__PURE__ */ a(Told, { asking }),
			byHand
		]
	});
}
function Compared({ path }) {
	const { value } = useRead(path);
	if (!value) return null;
	return /* @__PURE__ */ a("div", {
		class: "stack",
		children: [/* @__PURE__ */ a("p", { children: [
			/* @__PURE__ */ a("b", { children: [
				"v",
				value.old.version,
				" → v",
				value.new.version
			] }),
			" ",
			/* @__PURE__ */ a(Pulses, {
				axes: value.differences,
				signed: true
			})
		] }), /* @__PURE__ */ a(Changes, { changes: value.changes })]
	});
}
// src/parts/Vehicles.tsx
/** All vehicles in a table: what each does, and why one waits. */
var GROUPS = [
	"all",
	"alarm",
	"held",
	"waiting",
	"moving",
	"handling",
	"charging",
	"idle",
	"gone"
];
/** Idle at a parking place is said so: else one would look for why it does not move. */
function doing(vehicle) {
	return vehicle.parked && vehicle.activity === "idle" ? t("idle_parked") : said$1(vehicle.activity);
}
function Vehicles() {
	const letters = useSignal("");
	const group = useSignal("all");
	const wanted = letters.value.trim().toLowerCase();
	const rows = vehicleList.value.filter((vehicle) => (group.value === "all" || lookOf(vehicle) === group.value) && [
		vehicle.id,
		vehicle.job,
		vehicle.carrier,
		vehicle.goal,
		vehicle.barcode
	].some((name) => name?.toLowerCase().includes(wanted) ?? !wanted));
	return /* @__PURE__ */ a("section", {
		class: "room",
		"aria-label": t("vehicles"),
		children: [/* @__PURE__ */ a("div", {
			class: "head",
			children: [
				/* @__PURE__ */ a("h2", { children: [
					t("vehicles"),
					" ",
					counted(rows.length)
				] }),
				/* @__PURE__ */ a("select", {
					"aria-label": t("activity"),
					value: group.value,
					onChange: (event) => group.value = event.currentTarget.value,
					children: GROUPS.map((name) => /* @__PURE__ */ a("option", {
						value: name,
						children: name === "all" ? t("all") : t(`look_${name}`)
					}, name))
				}),
				/* @__PURE__ */ a("input", {
					type: "search",
					"aria-label": t("filter"),
					placeholder: t("filter"),
					value: letters.value,
					onInput: (event) => letters.value = event.currentTarget.value
				})
			]
		}), /* @__PURE__ */ a(Table, {
			label: t("vehicles"),
			rows,
			keyOf: (vehicle) => vehicle.id,
			pick: ({ id }) => selected.value = {
				kind: "vehicle",
				id
			},
			chosen: selected.value?.kind === "vehicle" ? selected.value.id : null,
			none: t("nothing_found"),
			columns: [
				{
					name: t("vehicle"),
					by: ({ id }) => id,
					of: (vehicle) => /* @__PURE__ */ a("button", {
						type: "button",
						class: "text",
						onClick: () => selected.value = {
							kind: "vehicle",
							id: vehicle.id
						},
						children: [
							/* @__PURE__ */ a("i", {
								class: "dot",
								style: { background: LOOKS[lookOf(vehicle)] }
							}),
							" ",
							vehicle.id
						]
					})
				},
				{
					name: t("activity"),
					by: doing,
					of: (vehicle) => /* @__PURE__ */ a("span", {
						style: { color: LOOKS[lookOf(vehicle)] },
						children: doing(vehicle)
					})
				},
				{
					name: t("place"),
					by: ({ barcode }) => barcode,
					of: ({ barcode }) => barcode ?? t("unknown")
				},
				{
					name: t("carrier"),
					by: ({ carrier, loaded }) => carrier ?? (loaded ? "~" : null),
					of: ({ carrier, loaded }) => loaded ? carrier ?? t("loaded") : ""
				},
				{
					name: t("job"),
					by: ({ job }) => job,
					of: ({ job }) => /* @__PURE__ */ a(Name, { id: job })
				},
				{
					name: t("goal"),
					by: ({ goal }) => goal,
					of: ({ goal }) => /* @__PURE__ */ a(Name, { id: goal })
				},
				{
					name: t("why"),
					wraps: true,
					of: (vehicle) => tell(vehicle.hold?.reason ?? vehicle.waiting)
				}
			]
		})]
	});
}
// src/parts/VehiclePanel.tsx
/** One vehicle: what it does and why not, its status bit by bit, its line, and the two decisions a person may take here. */
function VehiclePanel({ id }) {
	const now = vehicleNow(id);
	tick.value;
	if (!now) return /* @__PURE__ */ a(Missing, { id });
	const load = now.loaded === null ? t("unknown") : now.loaded ? now.carrier ?? t("loaded") : t("empty");
	return /* @__PURE__ */ a(Panel, {
		title: now.id,
		tag: doing(now),
		colour: LOOKS[lookOf(now)],
		children: [
			/* @__PURE__ */ a(Notes, { vehicle: now }),
			now.oper === "alarm" && /* @__PURE__ */ a(Recover, { vehicle: id }),
			/* @__PURE__ */ a("dl", { children: [
				/* @__PURE__ */ a(Fact, {
					name: t("state"),
					children: [
						said$1(now.state),
						" · ",
						said$1(now.service)
					]
				}),
				/* @__PURE__ */ a(Fact, {
					name: t("mode"),
					children: [
						upper$1(now.mode),
						" · ",
						upper$1(now.oper),
						now.code ? ` · ${hex(now.code)} ${now.code_name}` : ""
					]
				}),
				/* @__PURE__ */ a(Fact, {
					name: t("carrier"),
					children: load
				}),
				/* @__PURE__ */ a(Fact, {
					name: t(lineOf(id) ? "tag" : "place"),
					children: [now.barcode ?? t("unknown"), now.dist ? ` + ${now.dist} mm` : ""]
				}),
				/* @__PURE__ */ a(Fact, {
					name: t("job"),
					children: now.job ? /* @__PURE__ */ a(Name, { id: now.job }) : t("none")
				}),
				/* @__PURE__ */ a(Fact, {
					name: t("goal"),
					children: now.goal ? /* @__PURE__ */ a("button", {
						type: "button",
						class: "text",
						onClick: () => selected.value = {
							kind: "station",
							id: now.goal
						},
						children: now.goal
					}) : t("none")
				})
			] }),
			/* @__PURE__ */ a(Decide, { vehicle: now }),
			/* @__PURE__ */ a(VehicleCommands, { vehicle: now }),
			now.agv ? /* @__PURE__ */ a(AgvFacts, { agv: now.agv }) : /* @__PURE__ */ a(Bits, { vehicle: now }),
			/* @__PURE__ */ a(LinkFacts, { vehicle: now }),
			!now.agv && /* @__PURE__ */ a(Taught, {
				kind: "vehicle",
				id
			}),
			/* @__PURE__ */ a(Frames, { path: `/vehicles/${encodeURIComponent(id)}/frames` })
		]
	});
}
/** The line that an AGV shares with others; null for a hoist. */
var lineOf = (id) => layout.value?.vehicles.find((one) => one.id === id)?.link ?? null;
var upper$1 = (word) => word === null ? "–" : word.toUpperCase();
var hex = (code) => `0x${code.toString(16).toUpperCase().padStart(4, "0")}`;
/** Why it is locked out, held, or waits. */
function Notes({ vehicle }) {
	return /* @__PURE__ */ a($, { children: [
		vehicle.lockout && /* @__PURE__ */ a("p", {
			class: "note held",
			children: [
				/* @__PURE__ */ a("b", { children: t("locked", vehicle.lockout.owner) }),
				" ",
				vehicle.lockout.reason
			]
		}),
		vehicle.hold && /* @__PURE__ */ a("p", {
			class: "note held",
			children: [
				/* @__PURE__ */ a("b", { children: t("held_note") }),
				" ",
				tell(vehicle.hold.reason),
				" ",
				/* @__PURE__ */ a("em", { children: tell(vehicle.hold.remedy) })
			]
		}),
		vehicle.waiting && !vehicle.hold && /* @__PURE__ */ a("p", {
			class: "note waits",
			children: [
				/* @__PURE__ */ a("b", { children: t("waits") }),
				" ",
				tell(vehicle.waiting)
			]
		}),
		/* @__PURE__ */ a(Behind, { vehicle })
	] });
}
/** Who is behind a chain of waits, and how many wait because of this one. */
function Behind({ vehicle }) {
	const root = rootOf(vehicle, vehicleNow);
	const others = vehicleList.value.filter((other) => other.id !== vehicle.id && rootOf(other, vehicleNow)?.id === vehicle.id).length;
	return /* @__PURE__ */ a($, { children: [root && root.id !== vehicle.waits_for && /* @__PURE__ */ a("p", {
		class: "note waits",
		"data-root": root.id,
		children: [
			/* @__PURE__ */ a("b", { children: t("behind_it") }),
			" ",
			/* @__PURE__ */ a(Name, { id: root.id }),
			" ",
			tell(root.hold?.reason ?? root.waiting)
		]
	}), others > 0 && /* @__PURE__ */ a("p", {
		class: "note waits",
		children: t("wait_behind", others)
	})] });
}
function Bits({ vehicle }) {
	return /* @__PURE__ */ a("details", {
		open: true,
		children: [
			/* @__PURE__ */ a("summary", { children: [t(lineOf(vehicle.id) ? "status" : "status_bits"), !lineOf(vehicle.id) && /* @__PURE__ */ a("code", { children: [
				vehicle.status1 ?? "–",
				" ",
				vehicle.status2 ?? ""
			] })] }),
			vehicle.bits.length === 0 && /* @__PURE__ */ a("p", {
				class: "nothing",
				children: t("no_status")
			}),
			/* @__PURE__ */ a("table", {
				class: "bits",
				children: /* @__PURE__ */ a("tbody", { children: vehicle.bits.map((bit) => /* @__PURE__ */ a("tr", {
					"data-bit": bit.name,
					children: [
						/* @__PURE__ */ a("th", {
							title: said$1(`bit_${bit.name}`),
							children: bit.name.toUpperCase()
						}),
						/* @__PURE__ */ a("td", { children: bit.value }),
						/* @__PURE__ */ a("td", { children: [
							meaningOf(bit),
							" ",
							/* @__PURE__ */ a("small", {
								class: "calm",
								children: said$1(`bit_${bit.name}`)
							})
						] })
					]
				}, bit.name)) })
			})
		]
	});
}
/** A gripper's open and close are other words than a door's; what has no word is a number. */
function meaningOf({ name, meaning }) {
	if (name === "grip" && (meaning === "open" || meaning === "close")) return said$1(`grip_${meaning}`);
	if (name === "oper" && meaning === "pause") return said$1("pause_oper");
	return said$1(meaning);
}
function AgvFacts({ agv }) {
	const word = (name) => said$1(`agv_${name}`);
	const flag = (on) => t(on ? "yes" : "no");
	return /* @__PURE__ */ a("section", {
		class: "part",
		children: [/* @__PURE__ */ a("h3", { children: t("status") }), /* @__PURE__ */ a("dl", { children: [
			/* @__PURE__ */ a(Fact, {
				name: t("cart"),
				children: word(agv.cart)
			}),
			/* @__PURE__ */ a(Fact, {
				name: t("lift"),
				children: word(agv.lift)
			}),
			/* @__PURE__ */ a(Fact, {
				name: t("steering"),
				children: word(agv.steering)
			}),
			/* @__PURE__ */ a(Fact, {
				name: t("in_position"),
				children: flag(agv.in_position)
			}),
			/* @__PURE__ */ a(Fact, {
				name: t("charges_now"),
				children: flag(agv.charging)
			}),
			/* @__PURE__ */ a(Fact, {
				name: t("last_tag"),
				children: agv.tag
			}),
			agv.toward && /* @__PURE__ */ a(Fact, {
				name: t("beyond"),
				children: agv.toward
			}),
			/* @__PURE__ */ a(Fact, {
				name: t("path"),
				children: agv.path
			})
		] })]
	});
}
function LinkFacts({ vehicle }) {
	const { link } = vehicle;
	const line = lineOf(vehicle.id);
	return /* @__PURE__ */ a("dl", { children: [
		/* @__PURE__ */ a(Fact, {
			name: t("link"),
			children: [/* @__PURE__ */ a("span", {
				class: link.up ? "good" : "bad",
				children: t(link.up ? "link_up" : "link_down", clock(link.since))
			}), !link.up && link.reason && /* @__PURE__ */ a("small", { children: [" · ", tell(link.reason)] })]
		}),
		!line && /* @__PURE__ */ a(Fact, {
			name: t("round_trip"),
			children: link.round_trip_ms === null ? "–" : `${link.round_trip_ms.toFixed(1)} ms`
		}),
		/* @__PURE__ */ a(Fact, {
			name: t("frames_io"),
			children: [
				link.frames_in,
				" / ",
				link.frames_out
			]
		}),
		/* @__PURE__ */ a(Fact, {
			name: t("trouble_counts"),
			children: [
				link.garbled,
				" / ",
				link.resends,
				" / ",
				link.duplicates
			]
		}),
		/* @__PURE__ */ a(Fact, {
			name: t("seen"),
			children: vehicle.seen ? t("ago", span(serverNow() - Date.parse(vehicle.seen))) : "–"
		}),
		line ? /* @__PURE__ */ a(Fact, {
			name: t("on_line"),
			children: t("line_number", line, vehicle.dev_id)
		}) : /* @__PURE__ */ a(Fact, {
			name: t("address"),
			children: [
				vehicle.address,
				" · DEV_ID ",
				vehicle.dev_id,
				" · ",
				vehicle.dialect
			]
		})
	] });
}
var VERDICTS = [
	"go_on",
	"off_rail",
	"stands_at"
];
/** Hold a vehicle; release one that is held or absent. Both want a reason, a release a name as well. */
function Decide({ vehicle }) {
	const reason = useSignal("");
	const verdict = useSignal("go_on");
	const barcode = useSignal(vehicle.barcode ?? "");
	const error = useSignal(null);
	const releasing = vehicle.hold !== null || vehicle.activity === "absent" || vehicle.activity === "off_rail";
	const against = releasing ? againstVerdict(vehicle, verdict.value) : null;
	const send = (event) => {
		event.preventDefault();
		error.value = null;
		const path = `/vehicles/${encodeURIComponent(vehicle.id)}/${releasing ? "release" : "hold"}`;
		const stands = verdict.value === "stands_at" ? { barcode: barcode.value.trim() } : {};
		post(path, releasing ? {
			verdict: verdict.value,
			reason: reason.value,
			...stands
		} : { reason: reason.value }).then(() => reason.value = "", (failure) => error.value = failure);
	};
	return /* @__PURE__ */ a("form", {
		class: "decide",
		onSubmit: send,
		children: [
			releasing && /* @__PURE__ */ a("select", {
				"aria-label": t("verdict"),
				value: verdict.value,
				onChange: (event) => verdict.value = event.currentTarget.value,
				children: VERDICTS.map((word) => /* @__PURE__ */ a("option", {
					value: word,
					disabled: againstVerdict(vehicle, word) !== null,
					children: t(`verdict_${word}`)
				}, word))
			}),
			releasing && verdict.value === "stands_at" && /* @__PURE__ */ a("input", {
				"aria-label": t("barcode"),
				required: true,
				value: barcode.value,
				onInput: (event) => barcode.value = event.currentTarget.value
			}),
			/* @__PURE__ */ a("input", {
				"aria-label": t("reason"),
				placeholder: t("reason"),
				required: true,
				maxLength: 200,
				value: reason.value,
				onInput: (event) => reason.value = event.currentTarget.value
			}),
			/* @__PURE__ */ a(Button, {
				needs: releasing ? "POST /vehicles/{vehicle}/release" : "POST /vehicles/{vehicle}/hold",
				type: "submit",
				title: releasing && namesItself.value && !actor() ? t("your_name") : "",
				...stopped(against),
				children: t(releasing ? "release" : "hold")
			}),
			/* @__PURE__ */ a(Problem, { error: error.value })
		]
	});
}
// src/parts/PastPanels.tsx
/** What was recorded of the chosen thing at the moment that is shown: to be read, nothing can be done about it any more. */
function PastPanel({ pick }) {
	switch (pick.kind) {
		case "vehicle": return /* @__PURE__ */ a(PastVehicle, { id: pick.id });
		case "station": return /* @__PURE__ */ a(PastStation, { id: pick.id });
		case "job": return /* @__PURE__ */ a(PastJob, { id: pick.id });
		case "device": return /* @__PURE__ */ a(PastDevice, { id: pick.id });
		case "drive": return /* @__PURE__ */ a(PastDrive, { id: pick.id });
	}
}
function Unknown({ id }) {
	return /* @__PURE__ */ a(Panel, {
		title: id,
		tag: t("unknown"),
		colour: "var(--dim)",
		children: /* @__PURE__ */ a("p", {
			class: "nothing",
			children: t("not_then")
		})
	});
}
var upper = (word) => word?.toUpperCase() ?? "–";
function PastVehicle({ id }) {
	const then = vehicleNow(id);
	if (!then) return /* @__PURE__ */ a(Unknown, { id });
	const load = then.loaded === null ? t("unknown") : then.loaded ? then.carrier ?? t("loaded") : t("empty");
	return /* @__PURE__ */ a(Panel, {
		title: id,
		tag: doing(then),
		colour: LOOKS[lookOf(then)],
		children: [/* @__PURE__ */ a(Notes, { vehicle: then }), /* @__PURE__ */ a("dl", { children: [
			/* @__PURE__ */ a(Fact, {
				name: t("state"),
				children: [
					said$1(then.state),
					" · ",
					said$1(then.service)
				]
			}),
			/* @__PURE__ */ a(Fact, {
				name: t("mode"),
				children: [
					upper(then.mode),
					" · ",
					upper(then.oper),
					then.code ? ` · 0x${then.code.toString(16).toUpperCase().padStart(4, "0")}` : ""
				]
			}),
			/* @__PURE__ */ a(Fact, {
				name: t("carrier"),
				children: load
			}),
			/* @__PURE__ */ a(Fact, {
				name: t("place"),
				children: then.barcode ?? t("unknown")
			}),
			/* @__PURE__ */ a(Fact, {
				name: t("job"),
				children: then.job ? /* @__PURE__ */ a(Name, { id: then.job }) : t("none")
			}),
			/* @__PURE__ */ a(Fact, {
				name: t("goal"),
				children: then.goal ? /* @__PURE__ */ a(Name, { id: then.goal }) : t("none")
			}),
			/* @__PURE__ */ a(Fact, {
				name: t("granted"),
				children: then.granted.length > 0 ? then.granted.join(" ") : t("none")
			})
		] })]
	});
}
function PastStation({ id }) {
	const then = stationNow(id);
	if (!then) return /* @__PURE__ */ a(Unknown, { id });
	const occupied = then.present === null ? t("unknown") : then.present ? t("yes") : t("no");
	const buffer = layout.value?.stations.find((station) => station.id === id)?.buffer;
	return /* @__PURE__ */ a(Panel, {
		title: id,
		tag: said$1(then.kind),
		colour: then.present ? "var(--ink-carrier)" : "var(--ink-mark)",
		children: /* @__PURE__ */ a("dl", { children: [
			/* @__PURE__ */ a(Fact, {
				name: t("present"),
				children: [
					occupied,
					" ",
					/* @__PURE__ */ a("small", { children: [
						"(",
						then.verified ? t("verified") : t("believed"),
						")"
					] })
				]
			}),
			/* @__PURE__ */ a(Fact, {
				name: t("carrier"),
				children: then.carrier ?? t("none")
			}),
			/* @__PURE__ */ a(Fact, {
				name: t("reserved"),
				children: then.reserved || t("no")
			}),
			/* @__PURE__ */ a(Fact, {
				name: t("out_of_service"),
				children: then.out_of_service || t("no")
			}),
			/* @__PURE__ */ a(Fact, {
				name: t("barcode"),
				children: then.barcode
			}),
			buffer && /* @__PURE__ */ a(Fact, {
				name: t("buffer"),
				children: t(`device_${lookAt(buffer)}`)
			})
		] })
	});
}
function PastJob({ id }) {
	const then = jobList.value.find((job) => job.id === id);
	if (!then) return /* @__PURE__ */ a(Unknown, { id });
	return /* @__PURE__ */ a(Panel, {
		title: id,
		tag: said$1(then.state),
		colour: COLOURS$1[TONES$2[then.state] ?? "calm"],
		children: [then.reason && !ENDED.has(then.state) && /* @__PURE__ */ a("p", {
			class: "note waits",
			children: [
				/* @__PURE__ */ a("b", { children: t("waits") }),
				" ",
				tell(then.reason)
			]
		}), /* @__PURE__ */ a("dl", { children: [
			/* @__PURE__ */ a(Fact, {
				name: t("source"),
				children: /* @__PURE__ */ a(Name, { id: then.source })
			}),
			/* @__PURE__ */ a(Fact, {
				name: t("destination"),
				children: /* @__PURE__ */ a(Name, { id: then.destination })
			}),
			/* @__PURE__ */ a(Fact, {
				name: t("carrier"),
				children: then.carrier ?? t("unknown")
			}),
			/* @__PURE__ */ a(Fact, {
				name: t("vehicle"),
				children: then.vehicle ? /* @__PURE__ */ a(Name, { id: then.vehicle }) : t("none")
			}),
			/* @__PURE__ */ a(Fact, {
				name: t("priority"),
				children: then.priority
			}),
			/* @__PURE__ */ a(Fact, {
				name: t("ordered_by"),
				children: [
					then.actor,
					" ",
					/* @__PURE__ */ a("small", { children: ["· ", clock(then.created)] })
				]
			})
		] })]
	});
}
function PastDevice({ id }) {
	const then = deviceNow(id);
	const look = lookAt(id);
	const charger = layout.value?.chargers.some((one) => one.id === id);
	return /* @__PURE__ */ a(Panel, {
		title: id,
		tag: t(`device_${look}`),
		colour: colourOfDevice(then, look),
		children: [(then?.alarm || then?.reason) && /* @__PURE__ */ a("p", {
			class: "note waits",
			children: tell(then.alarm || then.reason)
		}), /* @__PURE__ */ a("dl", { children: [
			/* @__PURE__ */ a(Fact, {
				name: t("kind"),
				children: t(charger ? "charger" : "door")
			}),
			/* @__PURE__ */ a(Fact, {
				name: t("vehicles"),
				children: then?.vehicles.join(", ") || t("none")
			}),
			then?.out_of_service && /* @__PURE__ */ a(Fact, {
				name: t("out_of_service"),
				children: then.out_of_service
			})
		] })]
	});
}
/** Where it was is not recorded: only what it did, and what was wrong with it. */
function PastDrive({ id }) {
	const then = driveNow(id);
	if (!then) return /* @__PURE__ */ a(Unknown, { id });
	const { word, tone } = lookOfDrive(then);
	return /* @__PURE__ */ a(Panel, {
		title: id,
		tag: tell(then.name),
		colour: COLOURS$1[tone],
		children: [/* @__PURE__ */ a(Notes$1, { drive: then }), /* @__PURE__ */ a("dl", { children: [
			/* @__PURE__ */ a(Fact, {
				name: t("state"),
				children: /* @__PURE__ */ a("b", {
					class: tone,
					children: t(`drive_${word}`)
				})
			}),
			/* @__PURE__ */ a(Fact, {
				name: t(then.mode === "error" ? "error_fact" : "operation_fact"),
				children: [
					said$1(tell(then.meaning)) || "–",
					" ",
					/* @__PURE__ */ a("small", { children: then.code })
				]
			}),
			/* @__PURE__ */ a(Fact, {
				name: t("moves"),
				children: then.moving === null ? t("unknown") : t(then.moving ? "yes" : "no")
			}),
			/* @__PURE__ */ a(Fact, {
				name: t("on_line"),
				children: t("line_number", then.line, then.address)
			})
		] })]
	});
}
// src/past/marks.ts
/** What to look for in the past: the stretch of time that is drawn, the events of note in it, and the next one. */
var STRETCHES = {
	minutes: 600,
	hour: 3600,
	shift: 28800,
	day: 86400,
	all: Number.POSITIVE_INFINITY
};
var stretch = y$1("hour");
/** What the scrubber reaches over, UTC seconds. */
var reach = y$1({
	from: 0,
	to: 1
});
var marks = y$1([]);
/** The event that was stepped to last. */
var stepped = y$1(null);
/** Shown so long after an event, s: what it changed is published once it is durable. */
var AFTER = .5;
var MOST$1 = 1e3;
var iso$1 = (seconds) => (/* @__PURE__ */ new Date(seconds * 1e3)).toISOString();
var asked$1 = "";
/** Read the events of note in what the scrubber reaches over. */
async function readMarks() {
	const { from, to } = reach.value;
	const query = new URLSearchParams({
		from: iso$1(from),
		to: iso$1(to + 1),
		of_note: "true",
		newest: "true",
		limit: String(MOST$1)
	});
	asked$1 = String(query);
	try {
		const { items } = await get(`/history/events?${query}`);
		if (asked$1 === String(query)) marks.value = items;
	} catch (failure) {
		error.value = failure;
	}
}
/** From where to step: the event that is shown, or the moment if nobody stepped there. */
function origin() {
	const event = stepped.value;
	const at = event ? Date.parse(event.ts) / 1e3 : NaN;
	return Math.abs(at + AFTER - moment.value) < .01 ? at : moment.value;
}
/** Go to the next (1) or the one before (-1): of what is chosen, any event; else those of note. */
async function step(way) {
	const span = kept$1.value;
	if (!span) return;
	pause();
	const at = origin();
	const [from, to] = way > 0 ? [at + .001, span.to + 1] : [span.from, at];
	if (from >= to) return;
	const pick = selected.value;
	const query = new URLSearchParams({
		from: iso$1(from),
		to: iso$1(to),
		limit: "1",
		newest: String(way < 0)
	});
	if (pick?.kind === "vehicle" || pick?.kind === "job") query.set(pick.kind, pick.id);
	else query.set("of_note", "true");
	try {
		const { items } = await get(`/history/events?${query}`);
		stepped.value = items[0] ?? null;
		if (items[0]) await goTo(items[0]);
	} catch (failure) {
		error.value = failure;
	}
}
async function goTo(event) {
	pause();
	stepped.value = event;
	await seek(Date.parse(event.ts) / 1e3 + AFTER);
}
// src/past/reach.ts
var KINDS$1 = [
	[/^(AlarmSet|VehicleBrokenDown|DriveErrorSet|DriveOffline|.*Abort.*|.*Failed)$/, "alarm"],
	[/^(AlarmCleared|VehicleMended|DriveErrorCleared|VehicleReleased|EmergencyReleased|ControllerAuto|ZoneResumed|VehicleInstalled)$/, "over"],
	[/^Place/, "closure"],
	[/^(Emergency|Controller|Zone|VehicleHeld|VehicleRemoved)/, "halt"]
];
function kindOf(event) {
	return KINDS$1.find(([pattern]) => pattern.test(event))?.[1] ?? "other";
}
/** What the scrubber should reach over to show a moment: what it does now, if that is in it. Pure. */
function reachOf(at, span, length, now) {
	const whole = Math.max(span.to - span.from, 1);
	if (length >= whole) return {
		from: span.from,
		to: span.from + whole
	};
	if (Math.abs(now.to - now.from - length) < 1 && now.from <= at && at <= now.to && now.from >= span.from - 1) return now;
	const from = Math.min(Math.max(at - length / 2, span.from), span.to - length);
	return {
		from,
		to: from + length
	};
}
// src/parts/Scrubber.tsx
/** Moves through the time that was recorded: play, steps from event to event, a moment by its time, and an incident as a file. */
function Scrubber() {
	A$1(() => follow(), []);
	return /* @__PURE__ */ a($, { children: [
		/* @__PURE__ */ a("div", {
			class: "acts-row",
			children: [
				/* @__PURE__ */ a(Buttons, {}),
				/* @__PURE__ */ a("span", { class: "grow" }),
				/* @__PURE__ */ a(Jump, {}),
				/* @__PURE__ */ a(CopyLink, {})
			]
		}),
		/* @__PURE__ */ a(Line$1, {}),
		/* @__PURE__ */ a(Export, {})
	] });
}
/** Keep the moment within what is drawn, and the marks up to date. */
function follow() {
	const stops = [x(() => {
		const span = kept$1.value;
		if (!span || told.value === 0) return;
		const next = reachOf(told.value, span, STRETCHES[stretch.value], reach.peek());
		const { from, to } = reach.peek();
		if (next.from !== from || next.to !== to) reach.value = next;
	}), x(() => {
		if (reach.value.from > 0) readMarks();
	})];
	const key = (event) => {
		if (event.ctrlKey || event.metaKey || event.altKey || event.target.closest("input:not([type=range]), select, textarea")) return;
		const does = {
			",": () => void step(-1),
			".": () => void step(1),
			k: toggle
		};
		if (event.key === " " && !event.target.closest("button, a, summary")) does[" "] = toggle;
		if (!does[event.key]) return;
		event.preventDefault();
		does[event.key]?.();
	};
	document.addEventListener("keydown", key);
	return () => {
		for (const stop of stops) stop();
		document.removeEventListener("keydown", key);
	};
}
var toggle = () => playing.value ? pause() : play();
function Buttons() {
	return /* @__PURE__ */ a($, { children: [
		/* @__PURE__ */ a("button", {
			type: "button",
			title: `${t("event_before")} (,)`,
			"aria-label": t("event_before"),
			onClick: () => void step(-1),
			children: "|◀"
		}),
		/* @__PURE__ */ a("button", {
			type: "button",
			class: "primary play",
			title: `${t(playing.value ? "stop_playing" : "play")} (k)`,
			"aria-label": t(playing.value ? "stop_playing" : "play"),
			onClick: toggle,
			children: playing.value ? "❚❚" : "▶"
		}),
		/* @__PURE__ */ a("button", {
			type: "button",
			title: `${t("event_next")} (.)`,
			"aria-label": t("event_next"),
			onClick: () => void step(1),
			children: "▶|"
		}),
		/* @__PURE__ */ a("span", {
			class: "tabs",
			role: "group",
			"aria-label": t("pace"),
			children: PACES.map((times) => /* @__PURE__ */ a("button", {
				type: "button",
				"aria-pressed": pace.value === times,
				onClick: () => pace.value = times,
				children: ["×", times]
			}, times))
		}),
		/* @__PURE__ */ a("select", {
			"aria-label": t("stretch"),
			class: "narrow",
			value: stretch.value,
			onChange: (event) => stretch.value = event.currentTarget.value,
			children: Object.keys(STRETCHES).map((name) => /* @__PURE__ */ a("option", {
				value: name,
				children: t(`stretch_${name}`)
			}, name))
		})
	] });
}
/** The moment as a field for day and time has it. */
function local(seconds) {
	return dated(seconds).replace(" ", "T");
}
function Jump() {
	const span = kept$1.value;
	return /* @__PURE__ */ a("label", {
		class: "jump",
		children: [/* @__PURE__ */ a("span", { children: t("moment") }), /* @__PURE__ */ a("input", {
			type: "datetime-local",
			step: "1",
			min: span ? local(span.from) : void 0,
			max: span ? local(span.to) : void 0,
			value: told.value ? local(Math.floor(told.value)) : "",
			onChange: (event) => {
				const at = Date.parse(event.currentTarget.value) / 1e3;
				if (!Number.isNaN(at)) seek(at);
			}
		})]
	});
}
function CopyLink() {
	const done = useSignal(false);
	const copy = async () => {
		pause();
		await navigator.clipboard?.writeText(location.href).catch(() => void 0);
		done.value = true;
		window.setTimeout(() => done.value = false, 2e3);
	};
	return /* @__PURE__ */ a("button", {
		type: "button",
		title: t("link_hint"),
		onClick: () => void copy(),
		children: t(done.value ? "link_copied" : "link_copy")
	});
}
var cut = {
	from: 0,
	to: 0
};
function Line$1() {
	const { from, to } = reach.value;
	const share = (at) => `${100 * (at - from) / (to - from)}%`;
	return /* @__PURE__ */ a("div", {
		class: "scrubber",
		children: [
			/* @__PURE__ */ a(Marks, {}),
			/* @__PURE__ */ a("input", {
				type: "range",
				min: Math.floor(from),
				max: Math.ceil(to),
				step: "1",
				value: told.value,
				"aria-label": t("moment"),
				"aria-valuetext": dated(told.value),
				onInput: (event) => void seek(Number(event.currentTarget.value))
			}),
			/* @__PURE__ */ a("div", {
				class: "ends",
				"aria-hidden": "true",
				children: [
					/* @__PURE__ */ a("span", { children: dated(from) }),
					/* @__PURE__ */ a("span", {
						class: "here",
						style: { left: `clamp(2.4em, ${share(told.value)}, calc(100% - 2.4em))` },
						children: clock(iso$1(told.value))
					}),
					/* @__PURE__ */ a("span", { children: dated(to) })
				]
			})
		]
	});
}
/** Where something happened, by form and colour; the list beside the map says the same in words. */
function Marks() {
	const { from, to } = reach.value;
	return /* @__PURE__ */ a("div", {
		class: "marks",
		"aria-hidden": "true",
		children: marks.value.map((event) => {
			const at = (Date.parse(event.ts) / 1e3 - from) / (to - from);
			const title = `${clock(event.ts)} ${happening(event.event)} ${event.vehicle ?? event.source ?? ""}`;
			return /* @__PURE__ */ a("i", {
				class: `mark ${kindOf(event.event)}`,
				style: { left: `${100 * at}%` },
				title,
				onClick: () => void goTo(event)
			}, event.seq);
		})
	});
}
/** From when to when, and the file that `hoistway replay` opens. */
function Export() {
	const from = useSignal(cut.from);
	const to = useSignal(cut.to);
	const asking = useAsking();
	const span = kept$1.value;
	if (recording.value || !span) return null;
	const begin = from.value || Math.max(span.from, told.value - 300);
	const end = to.value || Math.min(span.to, told.value + 300);
	const field = (label, value, set) => /* @__PURE__ */ a($, { children: [/* @__PURE__ */ a("label", {
		class: "jump",
		children: [/* @__PURE__ */ a("span", { children: t(label) }), /* @__PURE__ */ a("input", {
			type: "datetime-local",
			step: "1",
			value: local(Math.floor(value)),
			onChange: (event) => set(Date.parse(event.currentTarget.value) / 1e3 || 0)
		})]
	}), /* @__PURE__ */ a("button", {
		type: "button",
		class: "plain",
		title: t("take_moment"),
		"aria-label": `${t(label)} ${t("here")}`,
		onClick: () => set(moment.value),
		children: t("here")
	})] });
	const save = () => {
		const query = new URLSearchParams({
			from: iso$1(begin),
			to: iso$1(end)
		});
		const name = `incident-${iso$1(begin).slice(0, 19).replaceAll(":", "")}Z.hoistway.gz`;
		asking.ask(() => download(`/history/export?${query}`, name), t("saved_as", name));
	};
	return /* @__PURE__ */ a("div", {
		class: "acts-row export",
		role: "group",
		"aria-label": t("incident"),
		children: [
			/* @__PURE__ */ a("b", { children: t("incident") }),
			field("from_moment", begin, (at) => from.value = cut.from = at),
			field("to_moment", end, (at) => to.value = cut.to = at),
			/* @__PURE__ */ a(Button, {
				needs: "GET /history/export",
				disabled: end <= begin || asking.busy.value,
				onClick: save,
				children: [t("incident_save"), " ⤓"]
			}),
			/* @__PURE__ */ a("small", {
				class: "calm",
				children: t("incident_hint")
			}),
			/* @__PURE__ */ a(Told, { asking })
		]
	});
}
// src/layers.ts
/** What lies over the track on the map, and what of it is shown. */
var LAYERS = [
	"grants",
	"zones",
	"closures",
	"holds"
];
var KEPT = "hoistway.layers";
function kept() {
	const all = Object.fromEntries(LAYERS.map((layer) => [layer, true]));
	try {
		const found = JSON.parse(localStorage.getItem(KEPT) ?? "{}");
		for (const layer of LAYERS) if (typeof found[layer] === "boolean") all[layer] = found[layer];
	} catch {}
	return all;
}
var layers = y$1(kept());
/** Which heat is shown over the track; none at first. */
var heatShown = y$1(null);
/** Over how many hours it is counted; 0: since this page was opened. */
var heatHours = y$1(1);
var HEAT_HOURS = [
	0,
	1,
	8,
	24
];
/** Whether the chosen vehicle is kept in the middle of the map. */
var following = y$1(false);
function show(layer, on) {
	layers.value = {
		...layers.value,
		[layer]: on
	};
	localStorage.setItem(KEPT, JSON.stringify(layers.value));
}
// src/gestures.ts
/** How people move the map and choose on it: pointer, wheel and keys. */
/** Listens on the map; `show` is told what lies under the pointer, and where that is. Returns how to stop. */
function listenTo(touched, paint, show) {
	const ends = new AbortController();
	const { signal } = ends;
	let from = null;
	touched.addEventListener("wheel", (event) => {
		event.preventDefault();
		paint.view.zoom(Math.exp(-event.deltaY * .0015), event.offsetX, event.offsetY);
		paint.move();
	}, {
		passive: false,
		signal
	});
	touched.addEventListener("pointerdown", (event) => {
		from = {
			x: event.offsetX,
			y: event.offsetY,
			moved: false
		};
		touched.setPointerCapture(event.pointerId);
	}, { signal });
	touched.addEventListener("pointermove", (event) => {
		const [x, y] = [event.offsetX, event.offsetY];
		if (from) {
			if (!from.moved && Math.hypot(x - from.x, y - from.y) < 4) return;
			paint.view.pan(x - from.x, y - from.y);
			from = {
				x,
				y,
				moved: true
			};
			show(null, 0, 0);
			following.value = false;
			paint.move();
			return;
		}
		paint.hovered = paint.at(x, y);
		touched.style.cursor = paint.hovered ? "pointer" : "grab";
		show(paint.hovered, Math.min(x + 14, paint.view.width - 250), Math.min(y + 14, paint.view.height - 90));
		paint.wake();
	}, { signal });
	touched.addEventListener("pointerup", (event) => {
		if (from && !from.moved) click(paint, event.offsetX, event.offsetY);
		from = null;
	}, { signal });
	touched.addEventListener("pointerleave", () => {
		paint.hovered = null;
		show(null, 0, 0);
		paint.wake();
	}, { signal });
	touched.addEventListener("keydown", (event) => void (keyed(event.key, paint) && event.preventDefault()), { signal });
	return () => ends.abort();
}
/** Choose what is there; while track is being chosen, the barcode. */
function click(paint, x, y) {
	const barcode = choosing.value ? paint.barcodeAt(x, y) : null;
	if (barcode !== null) choosing.value?.(barcode);
	else selected.value = paint.at(x, y);
}
function keyed(key, paint) {
	const { view } = paint;
	const step = 60;
	const move = {
		ArrowLeft: () => view.pan(step, 0),
		ArrowRight: () => view.pan(-60, 0),
		ArrowUp: () => view.pan(0, step),
		ArrowDown: () => view.pan(0, -60),
		"+": () => view.zoom(1.25, view.width / 2, view.height / 2),
		"-": () => view.zoom(.8, view.width / 2, view.height / 2),
		"0": () => paint.fit(),
		Escape: () => selected.value = null,
		f: () => following.value = !following.value
	}[key];
	move?.();
	if (move) paint.move();
	return move !== void 0;
}
// src/doors.ts
function doorMarks(layout, track) {
	return layout.doors.flatMap((door) => {
		return door.passages.flatMap(([a, b]) => track.way(a, b) ?? track.way(b, a) ?? []).map((way, i) => ({
			id: door.id,
			...track.along(way, way.edge.length / 2),
			named: i === 0
		}));
	});
}
// src/heat.ts
/** A longer gap between two reports is not counted as a wait, s. */
var GAP = 5;
var Heat = class Heat {
	/** Seconds waited, and vehicles that came, by barcode. */
	counts = {
		waiting: /* @__PURE__ */ new Map(),
		traffic: /* @__PURE__ */ new Map()
	};
	last = /* @__PURE__ */ new Map();
	/** What the server has counted. */
	static of(given) {
		const heat = new Heat();
		for (const kind of ["waiting", "traffic"]) for (const [barcode, count] of Object.entries(given[kind])) heat.add(kind, barcode, count);
		return heat;
	}
	clear() {
		this.last.clear();
		for (const counts of Object.values(this.counts)) counts.clear();
	}
	/** A vehicle's report at `now` (s). */
	take(vehicle, now) {
		const { barcode } = vehicle;
		if (barcode === null) return;
		const before = this.last.get(vehicle.id);
		if (before?.waits) this.add("waiting", before.barcode, Math.min(now - before.at, GAP));
		if (before && before.barcode !== barcode) this.add("traffic", barcode, 1);
		const waits = vehicle.activity === "waiting";
		if (!before) this.last.set(vehicle.id, {
			barcode,
			at: now,
			waits
		});
		else Object.assign(before, {
			barcode,
			at: now,
			waits
		});
	}
	/** Each counted barcode with its share of the most (0 to 1), on a scale on which half of it is still seen. */
	shares(kind) {
		const counts = this.counts[kind];
		let most = 0;
		for (const count of counts.values()) most = Math.max(most, count);
		return [...counts].map(([barcode, count]) => [barcode, Math.sqrt(count / most)]);
	}
	most(kind) {
		let most = 0;
		for (const count of this.counts[kind].values()) most = Math.max(most, count);
		return most;
	}
	add(kind, barcode, count) {
		this.counts[kind].set(barcode, (this.counts[kind].get(barcode) ?? 0) + count);
	}
};
// src/heats.ts
/** The heat of a period, as the server has counted it; null: what this page has seen itself is all there is. */
/** The server counts so many seconds together. */
var TOGETHER = 300;
/** So often it is asked again, s: it keeps what it counts as often. */
var EVERY$2 = 60;
var HOUR = 3600;
var heatKept = y$1(null);
/** Hours, and where they end (UTC s; 0: now); null: nothing is asked for. */
var wanted = O(() => {
	if (heatShown.value === null || heatHours.value === 0) return null;
	const end = inPast.value ? Math.ceil(told.value / TOGETHER) * TOGETHER : 0;
	return `${heatHours.value} ${end}`;
});
/** Ask for the heat that is wanted, again and again while it is that of the present. Returns how to end it. */
function begin$1() {
	let timer = 0;
	let last = 0;
	const ask = async (hours, end) => {
		const mine = ++last;
		const to = end || Date.now() / 1e3;
		const found = await get(`/history/heat?${new URLSearchParams({
			from: iso(to - hours * HOUR),
			...end ? { to: iso(end) } : {}
		})}`).catch(() => null);
		if (mine !== last) return;
		heatKept.value = found?.from ? Heat.of(found) : null;
		if (!end) timer = window.setTimeout(() => void ask(hours, end), EVERY$2 * 1e3);
	};
	const stop = x(() => {
		const now = wanted.value;
		clearTimeout(timer);
		last++;
		if (now === null) heatKept.value = null;
		else ask(...now.split(" ").map(Number));
	});
	return () => {
		clearTimeout(timer);
		last++;
		stop();
	};
}
var iso = (seconds) => (/* @__PURE__ */ new Date(seconds * 1e3)).toISOString();
// src/paint/ink.ts
var NAMES = [
	"ground",
	"rail",
	"tape",
	"core",
	"arrow",
	"zone",
	"soft",
	"mark",
	"frame",
	"text",
	"faint",
	"park",
	"carrier",
	"reserved",
	"closed",
	"picked",
	"plate",
	"plan"
];
/** The colours of the present theme, read from the style sheet by `dip`. */
var INK = Object.fromEntries(NAMES.map((name) => [name, "#888"]));
var LOOK_INK = { ...LOOKS };
var DEVICE_INK = { ...DEVICE_LOOKS };
/** From little to much; a scale that is also told apart without red and green. */
var HEAT = [];
var STEPS = 6;
/** Take the colours of the theme that is worn now. */
function dip() {
	const style = getComputedStyle(document.documentElement);
	const of = (name) => style.getPropertyValue(name).trim() || "#888888";
	for (const name of NAMES) INK[name] = of(`--ink-${name}`);
	for (const look of Object.keys(LOOK_INK)) LOOK_INK[look] = of(`--look-${look}`);
	for (const look of Object.keys(DEVICE_INK)) DEVICE_INK[look] = of(`--device-${look}`);
	HEAT.splice(0, HEAT.length, ...Array.from({ length: STEPS }, (_, i) => of(`--heat-${i + 1}`)));
}
var LETTERS = "\"Segoe UI\", Roboto, \"Noto Sans KR\", \"Malgun Gothic\", \"NanumGothic\", Arial, system-ui, sans-serif";
function font(px, weight = 400) {
	return `${weight} ${px}px ${LETTERS}`;
}
function text(ctx, words, x, y, colour, letters) {
	ctx.font = letters;
	ctx.textAlign = "center";
	ctx.fillStyle = colour;
	ctx.fillText(words, x, y);
}
var widths = /* @__PURE__ */ new Map();
/** Width of words in px; measured once, since names do not change. */
function widthOf(ctx, words, letters) {
	const key = `${letters}${words}`;
	const known = widths.get(key);
	if (known !== void 0) return known;
	if (widths.size > 2e4) widths.clear();
	ctx.font = letters;
	const { width } = ctx.measureText(words);
	widths.set(key, width);
	return width;
}
// src/paint/labels.ts
/** Height of a line of letters above and below its base line, px. */
var ABOVE = 10;
var BELOW = 3;
/** Boxes are looked up by the squares of this size that they lie in, px: hundreds of vehicles have names. */
var CELL = 64;
function boxOf$1(place, width) {
	return {
		x0: place.x - width / 2 - 2,
		x1: place.x + width / 2 + 2,
		y0: place.y - ABOVE,
		y1: place.y + BELOW
	};
}
var Labels = class {
	cells = /* @__PURE__ */ new Map();
	/** Keep a box free of names. */
	block(box) {
		for (const cell of cellsOf(box)) {
			const boxes = this.cells.get(cell);
			if (boxes) boxes.push(box);
			else this.cells.set(cell, [box]);
		}
	}
	free(box) {
		const touches = (b) => b.x0 < box.x1 && b.x1 > box.x0 && b.y0 < box.y1 && b.y1 > box.y0;
		return cellsOf(box).every((cell) => !this.cells.get(cell)?.some(touches));
	}
	/** Take the first place (middle of its base line) where a name of that width fits; returns which, -1: nowhere. */
	take(places, width) {
		const which = places.findIndex((place) => this.free(boxOf$1(place, width)));
		const place = places[which];
		if (place) this.block(boxOf$1(place, width));
		return which;
	}
};
function cellsOf({ x0, y0, x1, y1 }) {
	const cells = [];
	for (let x = Math.floor(x0 / CELL); x <= Math.floor(x1 / CELL); x++) for (let y = Math.floor(y0 / CELL); y <= Math.floor(y1 / CELL); y++) cells.push(`${x}/${y}`);
	return cells;
}
// src/paint/doors.ts
/** Drawing of doors: a bar across the track, whose form says what its colour says. */
/** Half the width of a doorway, mm. */
var WING = 750;
var wingOf = (view) => Math.max(13, WING * view.scale);
function paintDoors(ctx, view, scene, now, labels) {
	for (const mark of scene.doors) {
		const look = now.look(mark.id);
		const [px, py] = [view.px(mark.x), view.py(mark.y)];
		const wing = wingOf(view);
		const [w, h] = [Math.abs(Math.sin(mark.angle)) * wing + 6, Math.abs(Math.cos(mark.angle)) * wing + 6];
		labels.block({
			x0: px - w,
			y0: py - h,
			x1: px + w,
			y1: py + h
		});
		paintBar(ctx, px, py, mark.angle, wing, look);
		if (now.picked?.id === mark.id) {
			ctx.strokeStyle = INK.picked;
			ctx.lineWidth = 2;
			ctx.strokeRect(px - w - 2, py - h - 2, w * 2 + 4, h * 2 + 4);
		}
	}
	if (view.scale < .012) return;
	for (const mark of scene.doors.filter((one) => one.named)) paintName$1(ctx, view, mark, now, labels);
}
/**
* Closed: a whole bar. Open: its halves drawn back to the posts. Busy: the halves on their way, dotted between. Unknown: an
* empty bar. Not heard: a dashed one. Error: a whole bar crossed out.
*/
function paintBar(ctx, px, py, angle, wing, look) {
	const thick = Math.max(4, wing * .22);
	ctx.save();
	ctx.translate(px, py);
	ctx.rotate(angle);
	ctx.lineCap = "butt";
	ctx.strokeStyle = ctx.fillStyle = DEVICE_INK[look];
	ctx.lineWidth = 1.6;
	const bar = (from, to) => ctx.fillRect(-thick / 2, from, thick, to - from);
	if (look === "open") {
		bar(-wing, -wing * .62);
		bar(wing * .62, wing);
	} else if (look === "busy") {
		bar(-wing, -wing * .35);
		bar(wing * .35, wing);
		ctx.setLineDash([2, 2]);
		line(ctx, 0, -wing * .35, 0, wing * .35);
	} else if (look === "closed" || look === "error") bar(-wing, wing);
	else {
		ctx.fillStyle = INK.ground;
		bar(-wing, wing);
		ctx.setLineDash(look === "silent" ? [3, 3] : []);
		ctx.strokeRect(-thick / 2, -wing, thick, wing * 2);
	}
	ctx.setLineDash([]);
	if (look === "error") {
		const s = thick * 1.3;
		ctx.strokeStyle = INK.picked;
		line(ctx, -s, -s, s, s);
		line(ctx, -s, s, s, -s);
	}
	ctx.fillStyle = INK.text;
	for (const end of [-wing, wing]) ctx.fillRect(-thick / 2 - 2, end - 1.5, thick + 4, 3);
	ctx.restore();
}
function line(ctx, x0, y0, x1, y1) {
	ctx.beginPath();
	ctx.moveTo(x0, y0);
	ctx.lineTo(x1, y1);
	ctx.stroke();
}
/** A door's name, with its sign, beside one of its posts. */
function paintName$1(ctx, view, mark, now, labels) {
	const look = now.look(mark.id);
	const device = now.device(mark.id);
	const words = `${mark.id} ${signOfDevice(device, look)}`.trim();
	const letters = font(view.scale > .045 ? 12 : 10.5, 600);
	const width = widthOf(ctx, words, letters);
	const wing = wingOf(view);
	const [px, py] = [view.px(mark.x), view.py(mark.y)];
	const [w, h] = [Math.abs(Math.sin(mark.angle)) * wing, Math.abs(Math.cos(mark.angle)) * wing];
	const across = [{
		x: px + w + 11 + width / 2,
		y: py + 4
	}, {
		x: px - w - 11 - width / 2,
		y: py + 4
	}];
	const along = [{
		x: px,
		y: py - h - 11
	}, {
		x: px,
		y: py + h + 20
	}];
	const places = w > h ? [...across, ...along] : [...along, ...across];
	const place = places[labels.take(places, width)];
	if (place) text(ctx, words, place.x, place.y, DEVICE_INK[device?.alarm ? "error" : look], letters);
}
// src/places.ts
/** Where the marks of stations and chargers lie beside the track, and what is written at them. Pure. */
var OFFSET = {
	port: 720,
	agv_buffer: 1150,
	charger: 1150
};
var SIDE = 640;
var NEAR = 2200;
/** Room beyond this makes no difference, mm. */
var FURTHEST = 4e3;
/** Stations with the same first part of the name, of one kind, next to each other, on one side of the track. */
function clustersOf(layout, track) {
	const groups = [];
	const named = /* @__PURE__ */ new Map();
	const sides = sidesOf(layout);
	const chargers = layout.chargers.map(({ id, barcode }) => ({
		id,
		kind: "charger",
		barcode
	}));
	for (const { id, kind, barcode } of [...layout.stations, ...chargers]) {
		const spot = track.spot(barcode);
		if (!spot) continue;
		const cut = id.lastIndexOf("-");
		const name = cut > 0 ? id.slice(0, cut) : id;
		const near = (s) => s.kind === kind && Math.hypot(s.spot.x - spot.x, s.spot.y - spot.y) < NEAR;
		const mates = named.get(name)?.find((group) => group.stands.some(near));
		if (mates) mates.stands.push({
			id,
			kind,
			barcode,
			spot
		});
		else {
			const group = {
				name,
				stands: [{
					id,
					kind,
					barcode,
					spot
				}]
			};
			groups.push(group);
			named.set(name, [...named.get(name) ?? [], group]);
		}
	}
	return groups.map(({ name, stands }) => {
		const marks = beside(stands, sides, track);
		return {
			name: (named.get(name)?.length ?? 0) > 1 ? toldApart(name, marks) : name,
			marks
		};
	});
}
/** The name of one of several groups that begin alike: with its first and its last station. */
function toldApart(name, marks) {
	const shorts = marks.map(({ short }) => short).filter(Boolean).sort(NATURAL.compare);
	const [first, last] = [shorts[0], shorts.at(-1)];
	if (!first) return name;
	return first === last ? `${name}-${first}` : `${name}-${first}…${last}`;
}
function sidesOf(layout) {
	const of = (kind) => new Set(layout.stations.filter((station) => station.kind === kind).map((station) => station.barcode));
	return {
		sbfl: of("sbfl"),
		sbfr: of("sbfr")
	};
}
function beside(stands, sides, track) {
	const left = onLeft(stands, sides, track);
	return stands.map(({ id, kind, barcode, spot }) => {
		const sign = left ? 1 : -1;
		const [nx, ny] = [Math.sin(spot.angle) * sign, -Math.cos(spot.angle) * sign];
		const offset = OFFSET[kind] ?? SIDE;
		const short = id.includes("-") ? id.slice(id.lastIndexOf("-") + 1) : "";
		return {
			id,
			kind,
			barcode,
			x: spot.x + nx * offset,
			y: spot.y + ny * offset,
			angle: spot.angle,
			nx,
			ny,
			short
		};
	});
}
/** Side buffers have their side; everything else is drawn where there is more room. */
function onLeft(stands, sides, track) {
	const kind = stands[0]?.kind;
	if (kind === "sbfl" || kind === "sbfr") return kind === "sbfl";
	const taken = (side) => stands.some((stand) => sides[side].has(stand.barcode));
	if (taken("sbfl") !== taken("sbfr")) return taken("sbfr");
	const least = (sign) => Math.min(...stands.map(({ spot }) => room(track, spot, sign)));
	return least(1) > least(-1) + 1;
}
/** How far the nearest other track is on that side (1 left, -1 right), mm; bounded. */
function room(track, spot, sign) {
	const [nx, ny] = [Math.sin(spot.angle) * sign, -Math.cos(spot.angle) * sign];
	let least = FURTHEST;
	for (const point of track.grid.around(spot.x, spot.y, 5500)) {
		const [dx, dy] = [point.x - spot.x, point.y - spot.y];
		const across = dx * nx + dy * ny;
		const along = Math.abs(dx * ny - dy * nx);
		if (across > 300 && across < least && along < 1500) least = across;
	}
	return least;
}
// src/paint/stations.ts
/** Drawing of stations and chargers, with what is believed of them, and their names. */
/** Below this scale a station is a dot, and only what is occupied or closed is told apart. */
var DOTS = .011;
/** Below this one their machines have no names. */
var NAMED$1 = .012;
/** A line of letters, px. */
var FURTHER = 14;
/** `trouble`: what vehicles cover that stand there until somebody comes; names keep clear of it where they can. */
function paintStations(ctx, view, scene, now, labels, trouble) {
	const size = Math.max(7, 460 * view.scale);
	if (view.scale < DOTS) {
		paintDots$1(ctx, view, scene, now);
		return;
	}
	const buffers = new Map(scene.layout.stations.map((station) => [station.id, station.buffer]));
	const seen = scene.clusters.filter((cluster) => cluster.marks.some((mark) => near(view, mark)));
	const frames = seen.map((cluster) => frameOf(view, cluster, size));
	seen.forEach((cluster, i) => {
		const frame = frames[i];
		labels.block(frame);
		paintFrame(ctx, frame, cluster);
		for (const mark of cluster.marks) {
			const buffer = buffers.get(mark.id);
			if (mark.kind === "charger") paintCharger(ctx, view, mark, size, now);
			else paintMark(ctx, view, mark, size, now.station(mark.id), buffer ? now.device(buffer) : void 0);
			if (now.picked?.id === mark.id) paintPicked(ctx, view, mark, size);
		}
	});
	if (view.scale < NAMED$1) return;
	seen.forEach((cluster, i) => paintName(ctx, view, cluster, frames[i], labels, trouble));
}
function near(view, { x, y }) {
	return view.sees({
		x0: x,
		x1: x,
		y0: y,
		y1: y
	}, 120);
}
/** A whole fab at once: one path for each kind of dot. */
function paintDots$1(ctx, view, scene, now) {
	const size = Math.max(1.6, 460 * view.scale * 1.1);
	const kinds = [
		[INK.mark, (station) => !station?.present && !station?.out_of_service],
		[INK.carrier, (station) => station?.present === true && !station.out_of_service],
		[INK.closed, (station) => Boolean(station?.out_of_service)]
	];
	for (const [colour, is] of kinds) {
		ctx.fillStyle = colour;
		ctx.beginPath();
		for (const mark of scene.marks) if (near(view, mark) && is(now.station(mark.id))) ctx.rect(view.px(mark.x) - size / 2, view.py(mark.y) - size / 2, size, size);
		ctx.fill();
	}
	const picked = scene.marks.find((mark) => mark.id === now.picked?.id);
	if (picked) paintPicked(ctx, view, picked, 7);
}
function frameOf(view, cluster, size) {
	const [xs, ys] = [cluster.marks.map((m) => view.px(m.x)), cluster.marks.map((m) => view.py(m.y))];
	const pad = size * (cluster.marks[0]?.kind === "agv_buffer" || cluster.marks[0]?.kind === "charger" ? .75 : .5) + Math.max(3, size * .3);
	return {
		x0: Math.min(...xs) - pad,
		y0: Math.min(...ys) - pad,
		x1: Math.max(...xs) + pad,
		y1: Math.max(...ys) + pad
	};
}
function paintFrame(ctx, box, cluster) {
	ctx.fillStyle = INK.frame;
	ctx.beginPath();
	const round = cluster.marks[0]?.kind === "sbfl" || cluster.marks[0]?.kind === "sbfr";
	ctx.roundRect(box.x0, box.y0, box.x1 - box.x0, box.y1 - box.y0, round ? 12 : 3);
	ctx.fill();
}
function paintPicked(ctx, view, mark, size) {
	ctx.strokeStyle = INK.picked;
	ctx.lineWidth = 2;
	const half = size * (mark.kind === "agv_buffer" || mark.kind === "charger" ? .75 : .5) + 4;
	ctx.strokeRect(view.px(mark.x) - half, view.py(mark.y) - half, half * 2, half * 2);
}
function paintMark(ctx, view, mark, size, station, buffer) {
	const [px, py] = [view.px(mark.x), view.py(mark.y)];
	ctx.save();
	ctx.translate(px, py);
	ctx.lineWidth = Math.max(1.2, size * .1);
	ctx.strokeStyle = station?.out_of_service ? INK.closed : station?.reserved ? INK.reserved : INK.mark;
	if (mark.kind === "agv_buffer") paintBay(ctx, mark, size, buffer);
	else shape$1(ctx, mark.kind, size);
	if (station?.present) paintLoad(ctx, mark.kind, size, station.verified);
	else if (station?.present === null) text(ctx, "?", 0, size * .26, INK.faint, font(Math.round(size * .75), 700));
	if (station?.out_of_service) strike(ctx, size);
	ctx.restore();
	if (buffer) paintTrouble(ctx, px, py, size, buffer, lookOfDevice(buffer));
	if (view.scale > .055 && mark.short) {
		const [lx, ly] = [px + mark.nx * size * .95, py + mark.ny * size * .95 + 3];
		text(ctx, mark.short, lx, ly, INK.text, font(10));
	}
}
function strike(ctx, size) {
	ctx.beginPath();
	ctx.moveTo(-size / 2, -size / 2);
	ctx.lineTo(size / 2, size / 2);
	ctx.stroke();
}
/** Ports are square; side buffers are round. */
function shape$1(ctx, kind, size) {
	ctx.beginPath();
	if (kind === "port") ctx.roundRect(-size / 2, -size / 2, size, size, size * .16);
	else ctx.arc(0, 0, size * .52, 0, 7);
	ctx.fillStyle = INK.ground;
	ctx.fill();
	ctx.stroke();
}
/** An AGV's buffer is a bay, open towards the tape; dashed while its device is not heard. */
function paintBay(ctx, mark, size, buffer) {
	const half = size * .68;
	ctx.fillStyle = INK.ground;
	ctx.fillRect(-half, -half, half * 2, half * 2);
	ctx.save();
	ctx.rotate(Math.atan2(mark.ny, mark.nx) - Math.PI / 2);
	ctx.setLineDash(buffer && lookOfDevice(buffer) === "silent" ? [size * .3, size * .22] : []);
	ctx.lineCap = "butt";
	ctx.lineWidth = Math.max(1.8, size * .16);
	if (buffer?.lock) ctx.strokeStyle = INK.reserved;
	ctx.beginPath();
	ctx.moveTo(-half, -half);
	ctx.lineTo(-half, half);
	ctx.lineTo(half, half);
	ctx.lineTo(half, -half);
	ctx.stroke();
	ctx.restore();
}
/** A FOUP is a square; a cart has wheels. */
function paintLoad(ctx, kind, size, verified) {
	ctx.fillStyle = INK.carrier;
	ctx.globalAlpha = verified ? 1 : .92;
	const s = size * (kind === "agv_buffer" ? .72 : .54);
	if (kind !== "agv_buffer") ctx.fillRect(-s / 2, -s / 2, s, s);
	else {
		ctx.fillRect(-s / 2, -s / 2, s, s * .7);
		ctx.beginPath();
		for (const side of [-1, 1]) ctx.arc(side * s * .3, s * .36, s * .17, 0, 7);
		ctx.fill();
	}
	ctx.globalAlpha = 1;
}
/** A buffer that does not answer or is in error says so by a sign at its corner. */
function paintTrouble(ctx, px, py, size, device, look) {
	const sign = signOfDevice(device, look);
	if (!sign) return;
	const [x, y] = [px + size * .75, py - size * .75];
	ctx.fillStyle = DEVICE_INK[device?.alarm ? "error" : look];
	ctx.beginPath();
	ctx.arc(x, y, 6, 0, 7);
	ctx.fill();
	text(ctx, sign, x, y + 3.5, INK.ground, font(10, 700));
}
/** A charger is a flash in a diamond: filled while somebody charges, crossed out while it is out of service. */
function paintCharger(ctx, view, mark, size, now) {
	const device = now.device(mark.id);
	const look = now.look(mark.id);
	const half = size * .85;
	ctx.save();
	ctx.translate(view.px(mark.x), view.py(mark.y));
	ctx.strokeStyle = device?.out_of_service ? INK.closed : DEVICE_INK[look];
	ctx.fillStyle = look === "charging" ? DEVICE_INK.charging : INK.ground;
	ctx.lineWidth = Math.max(1.4, size * .11);
	ctx.beginPath();
	ctx.moveTo(0, -half);
	ctx.lineTo(half, 0);
	ctx.lineTo(0, half);
	ctx.lineTo(-half, 0);
	ctx.closePath();
	ctx.fill();
	ctx.stroke();
	ctx.fillStyle = look === "charging" ? INK.ground : DEVICE_INK[look];
	flash(ctx, size * 1.05);
	if (device?.out_of_service) strike(ctx, size * 1.2);
	ctx.restore();
	if (device) paintTrouble(ctx, view.px(mark.x), view.py(mark.y), size, device, look);
}
function flash(ctx, size) {
	const s = size / 2;
	ctx.beginPath();
	ctx.moveTo(s * .25, -s);
	ctx.lineTo(-s * .5, s * .15);
	ctx.lineTo(-s * .02, s * .15);
	ctx.lineTo(-s * .25, s);
	ctx.lineTo(s * .5, -s * .15);
	ctx.lineTo(s * .02, -s * .15);
	ctx.closePath();
	ctx.fill();
}
/**
* The name goes away from the track if there is room, else to another side of the frame, else nowhere. Where a vehicle in trouble
* stands over all of these, it goes a line further off.
*/
function paintName(ctx, view, cluster, frame, labels, trouble) {
	const letters = font(view.scale > .045 ? 12 : 10.5, 600);
	const width = widthOf(ctx, cluster.name, letters);
	const half = width / 2;
	const more = view.scale > .055 && cluster.marks.some((mark) => mark.short) ? 13 : 0;
	const { nx, ny } = cluster.marks[0];
	const [mx, my] = [(frame.x0 + frame.x1) / 2, (frame.y0 + frame.y1) / 2];
	const above = {
		x: mx,
		y: frame.y0 - 5 - (ny < -.5 ? more : 0)
	};
	const below = {
		x: mx,
		y: frame.y1 + 12 + (ny > .5 ? more : 0)
	};
	const left = {
		x: frame.x0 - 5 - half - (nx < -.5 ? more : 0),
		y: my + 4
	};
	const right = {
		x: frame.x1 + 5 + half + (nx > .5 ? more : 0),
		y: my + 4
	};
	const flat = Math.abs(ny) > Math.abs(nx);
	const first = flat ? ny < 0 ? above : below : nx < 0 ? left : right;
	const away = nx < 0 ? frame.x1 - half : frame.x0 + half;
	const room = [first, ...flat ? [left, right] : [
		{
			...above,
			x: away
		},
		{
			...below,
			x: away
		},
		above,
		below
	]].filter((one) => labels.free(boxOf$1(one, width)));
	const further = [above, below].flatMap(({ x, y }) => [
		x,
		left.x,
		right.x
	].map((at) => ({
		x: at,
		y: y + (y < my ? -14 : FURTHER)
	})));
	const places = [...[...room, ...room.length > 0 ? further : []].filter((one) => trouble.free(boxOf$1(one, width))), ...room];
	const place = places[labels.take(places, width)];
	if (place) text(ctx, cluster.name, place.x, place.y, INK.text, letters);
}
// src/paint/plant.ts
/** Below this scale a whole fab is on the map, and what is small is left out. */
var FINE = .011;
/** Draws the plant; returns what room names and marks take, for those that are drawn over it. `trouble`: what names keep clear of. */
function paintPlant(ctx, view, scene, now, trouble) {
	ctx.lineJoin = "round";
	const rail = Math.min(14, Math.max(view.scale < FINE ? 1.6 : 3, 260 * view.scale));
	ctx.lineCap = view.scale < FINE ? "butt" : "round";
	const ways = [...scene.track.ways.values()].filter((way) => view.sees(way.box));
	if (now.zones) paintZones(ctx, view, scene, rail);
	paintRails(ctx, view, scene.track, ways, rail);
	if (view.scale > FINE) paintArrows(ctx, view, scene.track, ways, rail);
	paintDots(ctx, view, scene.track, rail);
	const labels = new Labels();
	paintDoors(ctx, view, scene, now, labels);
	const kept = new Labels();
	for (const box of trouble) kept.block(box);
	paintStations(ctx, view, scene, now, labels, kept);
	nameBarcodes(ctx, view, scene.track, rail, labels);
	return labels;
}
/** Zones are broad bands under the track: no-stop and capped ones whole, soft ones dotted. */
function paintZones(ctx, view, scene, rail) {
	const width = Math.max(rail + (view.scale < FINE ? 3 : 8), 900 * view.scale);
	const of = (which) => scene.layout.zones.filter(which).flatMap((zone) => inside(scene.track, zone));
	ctx.strokeStyle = INK.zone;
	ctx.globalAlpha = .24;
	stroke(ctx, view, of((zone) => zone.no_stop && !zone.soft), width);
	ctx.globalAlpha = .15;
	stroke(ctx, view, of((zone) => !zone.no_stop && !zone.soft), width);
	ctx.strokeStyle = INK.soft;
	ctx.globalAlpha = .4;
	ctx.setLineDash([2, width * .8]);
	stroke(ctx, view, of((zone) => zone.soft !== null), width);
	ctx.setLineDash([]);
	ctx.globalAlpha = 1;
}
function inside(track, zone) {
	const barcodes = new Set(zone.barcodes);
	return zone.barcodes.flatMap((barcode) => (track.next.get(barcode) ?? []).filter((edge) => barcodes.has(edge.end)).flatMap((edge) => track.way(edge.start, edge.end) ?? []));
}
/** Rail hangs and is hollow; tape lies on the floor and is thin. */
function paintRails(ctx, view, track, ways, rail) {
	const hung = ways.filter((way) => !track.floor.has(way.edge.start));
	ctx.strokeStyle = INK.tape;
	stroke(ctx, view, ways.filter((way) => track.floor.has(way.edge.start)), Math.max(2.5, rail * .6));
	ctx.strokeStyle = INK.rail;
	stroke(ctx, view, hung, rail);
	if (rail <= 5) return;
	ctx.strokeStyle = INK.core;
	stroke(ctx, view, hung, rail * .45);
}
function stroke(ctx, view, ways, width) {
	ctx.lineWidth = width;
	ctx.beginPath();
	let [lastX, lastY] = [NaN, NaN];
	for (const { pts } of ways) {
		const first = pts[0];
		if (first.x !== lastX || first.y !== lastY) ctx.moveTo(view.px(first.x), view.py(first.y));
		for (let i = 1; i < pts.length; i++) {
			const point = pts[i];
			ctx.lineTo(view.px(point.x), view.py(point.y));
			[lastX, lastY] = [point.x, point.y];
		}
	}
	ctx.stroke();
}
/** One arrow where track is driven one way; two, back to back, where it is driven both ways. */
function paintArrows(ctx, view, track, ways, rail) {
	ctx.strokeStyle = INK.arrow;
	ctx.lineWidth = Math.max(1.2, rail * .16);
	const size = Math.max(3, rail * .42);
	const every = Math.max(1500, 95 / view.scale);
	let gone = every / 2;
	let both = every;
	ctx.beginPath();
	for (const way of ways) {
		const { edge } = way;
		const double = track.twoWay(edge);
		if (double && edge.start > edge.end) continue;
		if (double) both += edge.length;
		else gone += edge.length;
		if ((double ? both : gone) < every) continue;
		if (double) both = 0;
		else gone = 0;
		const { x, y, angle } = track.along(way, edge.length / 2);
		const [px, py] = [view.px(x), view.py(y)];
		const apart = double ? size * 1.3 : 0;
		arrow(ctx, px + Math.cos(angle) * apart, py + Math.sin(angle) * apart, angle, size);
		if (double) arrow(ctx, px - Math.cos(angle) * apart, py - Math.sin(angle) * apart, angle + Math.PI, size);
	}
	ctx.stroke();
}
function arrow(ctx, px, py, angle, size) {
	const [c, s] = [Math.cos(angle) * size, Math.sin(angle) * size];
	ctx.moveTo(px - c * .5 + s, py - s * .5 - c);
	ctx.lineTo(px + c * .5, py + s * .5);
	ctx.lineTo(px - c * .5 - s, py - s * .5 + c);
}
function paintDots(ctx, view, track, rail) {
	if (view.scale < FINE) return;
	for (const { x, y, park } of track.points.values()) {
		if (!park && view.scale <= .05) continue;
		if (!view.sees({
			x0: x,
			x1: x,
			y0: y,
			y1: y
		})) continue;
		ctx.fillStyle = park ? INK.park : INK.arrow;
		ctx.beginPath();
		ctx.arc(view.px(x), view.py(y), park ? Math.max(1.6, rail * .16) : Math.max(1, rail * .1), 0, 7);
		ctx.fill();
	}
}
/** Barcodes and tags have their names where there is room: tags lie further apart. */
function nameBarcodes(ctx, view, track, rail, labels) {
	const letters = font(10);
	if (view.scale <= .045) return;
	for (const [barcode, { x, y }] of track.points) {
		if (view.scale <= (track.floor.has(barcode) ? .045 : .085)) continue;
		const [px, py] = [view.px(x), view.py(y)];
		if (px < -50 || py < -50 || px > view.width + 50 || py > view.height + 50) continue;
		const width = widthOf(ctx, barcode, letters);
		const places = besides(track, barcode, rail * .5 + 5, width).map(({ x: dx, y: dy }) => ({
			x: px + dx,
			y: py + dy
		}));
		const place = places[labels.take(places, width)];
		if (place) text(ctx, barcode, place.x, place.y, INK.faint, letters);
	}
}
/** Where a barcode's name can stand, from the barcode: on the sides where no track leaves. */
function besides(track, barcode, away, width) {
	const angles = [...(track.next.get(barcode) ?? []).flatMap((edge) => track.way(edge.start, edge.end) ?? []).map((way) => track.along(way, 0).angle), ...(track.before.get(barcode) ?? []).flatMap((edge) => track.way(edge.start, edge.end) ?? []).map((way) => track.along(way, way.edge.length).angle + Math.PI)];
	return [
		{
			angle: -Math.PI / 2,
			x: 0,
			y: -away
		},
		{
			angle: Math.PI / 2,
			x: 0,
			y: away + 8
		},
		{
			angle: 0,
			x: away + width / 2,
			y: 3
		},
		{
			angle: Math.PI,
			x: -away - width / 2,
			y: 3
		}
	].filter((side) => angles.every((angle) => Math.cos(angle - side.angle) < .6));
}
// src/paint/vehicles.ts
/** Drawing of what moves: vehicles and their names. A thousand are drawn in a few paths, one for each way to look. */
/** Drawn last: what needs a person lies over what does not. */
var ORDER = [
	"gone",
	"idle",
	"charging",
	"moving",
	"handling",
	"waiting",
	"held",
	"alarm"
];
/** Vehicles: solid with a carrier aboard, hollow without. A hoist has a nose; an AGV, which drives both ways, has wheels. */
function paintFleet(ctx, view, bodies) {
	const groups = /* @__PURE__ */ new Map();
	for (const body of bodies) {
		const group = groups.get(body.look);
		if (group) group.push(body);
		else groups.set(body.look, [body]);
	}
	ctx.lineJoin = "round";
	for (const look of ORDER) {
		const group = groups.get(look);
		if (group) paintGroup(ctx, view, group, LOOK_INK[look], look === "gone");
	}
}
function paintGroup(ctx, view, bodies, colour, dashed) {
	if (sizeOf(view, bodies[0])[0] < SMALL) {
		paintSmall(ctx, view, bodies, colour);
		return;
	}
	const agvs = bodies.filter((body) => body.agv);
	if (agvs.length > 0) fill(ctx, INK.arrow, () => agvs.forEach((body) => wheels(ctx, view, body)));
	const loaded = bodies.filter((body) => body.vehicle.loaded);
	const empty = bodies.filter((body) => !body.vehicle.loaded);
	const hulls = (some) => () => some.forEach((body) => hull(ctx, view, body));
	fill(ctx, INK.ground, hulls(empty));
	ctx.globalAlpha = .3;
	fill(ctx, colour, hulls(empty));
	ctx.globalAlpha = 1;
	fill(ctx, colour, hulls(loaded));
	ctx.strokeStyle = colour;
	ctx.lineWidth = 1.8;
	ctx.setLineDash(dashed ? [3, 3] : []);
	ctx.beginPath();
	hulls(bodies)();
	ctx.stroke();
	ctx.setLineDash([]);
	fill(ctx, INK.carrier, () => loaded.forEach((body) => load(ctx, view, body)));
	ctx.strokeStyle = INK.ground;
	ctx.lineWidth = 1.4;
	ctx.stroke();
}
/** A whole fab at once: wedges, with a dot where a carrier is aboard. */
function paintSmall(ctx, view, bodies, colour) {
	fill(ctx, colour, () => {
		for (const body of bodies) {
			const [length, width] = sizeOf(view, body);
			const [l, w] = [length / 2, width / 2];
			shape(ctx, view, body, body.agv ? [
				-l,
				-w,
				l,
				-w,
				l,
				w,
				-l,
				w
			] : [
				-l,
				-w,
				l,
				0,
				-l,
				w
			]);
		}
	});
	fill(ctx, INK.carrier, () => {
		for (const { vehicle, spot } of bodies) if (vehicle.loaded) ctx.rect(view.px(spot.x) - 1.5, view.py(spot.y) - 1.5, 3, 3);
	});
}
function fill(ctx, colour, path) {
	ctx.fillStyle = colour;
	ctx.beginPath();
	path();
	ctx.fill();
}
/** A ring around one that is looked at, and a beat around one in alarm. */
function paintRings(ctx, view, bodies, strength, pulse) {
	for (const body of bodies) {
		const [length] = sizeOf(view, body);
		if (body.look === "alarm") ring(ctx, view, body, length * (.75 + .25 * pulse), LOOK_INK.alarm, .8 - .6 * pulse);
		const alpha = strength(body);
		if (alpha > 0) ring(ctx, view, body, length * .8, INK.picked, alpha);
	}
}
function ring(ctx, view, { spot }, radius, colour, alpha) {
	ctx.strokeStyle = colour;
	ctx.globalAlpha = alpha;
	ctx.lineWidth = 2;
	ctx.beginPath();
	ctx.arc(view.px(spot.x), view.py(spot.y), radius, 0, 7);
	ctx.stroke();
	ctx.globalAlpha = 1;
}
/** A closed shape around the vehicle: pairs along and across it, in px. */
function shape(ctx, view, { spot }, corners) {
	const [px, py] = [view.px(spot.x), view.py(spot.y)];
	const [c, s] = [Math.cos(spot.angle), Math.sin(spot.angle)];
	for (let i = 0; i < corners.length; i += 2) {
		const [along, across] = [corners[i], corners[i + 1]];
		const [x, y] = [px + along * c - across * s, py + along * s + across * c];
		if (i === 0) ctx.moveTo(x, y);
		else ctx.lineTo(x, y);
	}
	ctx.closePath();
}
/** A box with its nose forward, or, for an AGV, one that is the same at both ends. */
function hull(ctx, view, body) {
	const [length, width] = sizeOf(view, body);
	const [l, w] = [length / 2, width / 2];
	if (body.agv) shape(ctx, view, body, [
		-l,
		-w,
		l,
		-w,
		l,
		w,
		-l,
		w
	]);
	else shape(ctx, view, body, [
		-l,
		-w * .8,
		-l + w * .2,
		-w,
		l - w * .7,
		-w,
		l,
		0,
		l - w * .7,
		w,
		-l + w * .2,
		w,
		-l,
		w * .8
	]);
}
function wheels(ctx, view, body) {
	const [length, width] = sizeOf(view, body);
	const [long, thick] = [length * .24, Math.max(2.5, width * .16)];
	for (const x of [-length * .42, length * .42 - long]) for (const y of [-width / 2 - thick - 1, width / 2 + 1]) shape(ctx, view, body, [
		x,
		y,
		x + long,
		y,
		x + long,
		y + thick,
		x,
		y + thick
	]);
}
/** The carrier aboard. */
function load(ctx, view, body) {
	const [length, width] = sizeOf(view, body);
	const s = width * .28;
	const x = body.agv ? 0 : -length * .06;
	shape(ctx, view, body, [
		x - s,
		-s,
		x + s,
		-s,
		x + s,
		s,
		x - s,
		s
	]);
}
/** Shorter than this a hull has thin lines, px. */
var SMALL = 13;
/** From this scale on all vehicles have names; below it those do that are looked at or need a person. */
var NAMED = .014;
/** So few vehicles have names at any scale. */
var FEW = 60;
/** Height of a vehicle's name with its ground, px. */
var LINE = 15;
/** So many lines away from its vehicle a name is set at most where nothing nearer is free; a line leads to it. */
var FARTHEST = 8;
/**
* Names beside their vehicles. One that is looked at or in trouble goes first; each stays on its side while there is room; where
* there is none at all, the name is left out unless it is one of those: then it is set where both it and what stands still can be
* read, with a line to its vehicle.
*/
var Signs = class {
	sides = /* @__PURE__ */ new Map();
	/** `still`: whether a box is free of the names of what stands still; they are covered only where nothing around is free. `shown`: what is seen of the sheet. */
	paint(ctx, view, seen, first, still, shown) {
		const labels = new Labels();
		const rank = (body) => first(body) ? 0 : urgent(body) ? 1 : 2;
		const all = view.scale > NAMED || seen.length < FEW;
		const named = all ? seen : seen.filter((body) => rank(body) < 2).slice(0, FEW);
		for (const body of all ? seen : named) labels.block(hullOf(view, body));
		for (const body of named.toSorted((a, b) => rank(a) - rank(b))) this.sign(ctx, view, body, rank(body) < 2, first(body), labels, still, shown);
	}
	sign(ctx, view, body, must, ringed, labels, still, shown) {
		const { vehicle, look } = body;
		const words = SIGNS[look] ? `${vehicle.id} ${SIGNS[look]}` : vehicle.id;
		const width = widthOf(ctx, words, font(11, 700)) + 8;
		const places = placesFor(view, body, width, ringed);
		const side = this.sides.get(vehicle.id) ?? 0;
		const clear = [side, ...places.keys()].filter((one) => one < places.length).filter((one) => labels.free(grown(places[one], width)));
		const free = (place) => labels.free(grown(place, width)) && still(grown(place, width));
		let found = clear.find((one) => still(grown(places[one], width)));
		if (found === void 0 && must) {
			const near = places.length;
			places.push(...away(view, body, width, shown));
			found = side >= near && side < places.length && free(places[side]) ? side : places.findIndex((place, one) => one >= near && free(place));
			if (found < 0) found = clear[0] ?? 0;
			else lead(ctx, view, body, places[found], LOOK_INK[look]);
		}
		if (found === void 0) return;
		this.sides.set(vehicle.id, found);
		const { x, y } = places[found];
		labels.block(grown({
			x,
			y
		}, width));
		ctx.fillStyle = INK.plate;
		ctx.beginPath();
		ctx.roundRect(x - width / 2, y - 11.5, width, LINE, 4);
		ctx.fill();
		text(ctx, words, x, y, LOOK_INK[look], font(11, 700));
	}
};
/** What a vehicle in trouble covers, with its ring or brackets, px. */
function coveredBy(view, body) {
	const hull = hullOf(view, body);
	const [px, py] = [view.px(body.spot.x), view.py(body.spot.y)];
	const r = Math.max(10, 900 * view.scale) + 2;
	return {
		x0: Math.min(hull.x0, px - r),
		x1: Math.max(hull.x1, px + r),
		y0: Math.min(hull.y0, py - r),
		y1: Math.max(hull.y1, py + r)
	};
}
function urgent({ look }) {
	return look === "alarm" || look === "held";
}
function grown(place, width) {
	return boxOf$1(place, width - 3);
}
function visible(view, { spot }) {
	return view.sees({
		x0: spot.x,
		x1: spot.x,
		y0: spot.y,
		y1: spot.y
	}, 50);
}
/** In px. On a whole fab they are smaller than they should be to be seen well, so that they do not lie on each other. */
var sizeOf = (view, { length, agv }) => {
	const least = view.scale < .02 ? Math.max(7.5, view.scale * 850) : 17;
	return [Math.max(least, length * .82 * view.scale), Math.max(least * (agv ? .76 : .65), (agv ? 700 : 560) * view.scale)];
};
function hullOf(view, body) {
	const [length, width] = sizeOf(view, body);
	const [c, s] = [Math.abs(Math.cos(body.spot.angle)), Math.abs(Math.sin(body.spot.angle))];
	const [w, h] = [(length * c + width * s) / 2, (length * s + width * c) / 2];
	const [px, py] = [view.px(body.spot.x), view.py(body.spot.y)];
	return {
		x0: px - w,
		x1: px + w,
		y0: py - h,
		y1: py + h
	};
}
/** Around the ring of one that is looked at. */
function ringOf(view, body) {
	const radius = sizeOf(view, body)[0] * .8;
	const [px, py] = [view.px(body.spot.x), view.py(body.spot.y)];
	return {
		x0: px - radius,
		x1: px + radius,
		y0: py - radius,
		y1: py + radius
	};
}
/** Around the hull, nearest first, as far as the map is seen. */
function away(view, { spot }, width, shown) {
	const [px, py] = [view.px(spot.x), view.py(spot.y)];
	const places = [];
	for (let line = 2; line <= FARTHEST; line++) for (let turn = 0; turn < 16; turn++) {
		const angle = turn * Math.PI / 8 - Math.PI / 2;
		const x = px + Math.cos(angle) * (line * LINE + width / 2);
		const y = py + 4 + Math.sin(angle) * line * LINE;
		if (x - width / 2 > shown.x0 && x + width / 2 < shown.x1 && y - LINE > shown.y0 && y + 4 < shown.y1) places.push({
			x,
			y
		});
	}
	return places;
}
/** A line from the hull to its name. */
function lead(ctx, view, body, { x, y }, colour) {
	const [px, py] = [view.px(body.spot.x), view.py(body.spot.y)];
	const [dx, dy] = [x - px, y - 4 - py];
	const from = sizeOf(view, body)[0] * .55 / Math.max(1, Math.hypot(dx, dy));
	ctx.strokeStyle = colour;
	ctx.lineWidth = 1.4;
	ctx.beginPath();
	ctx.moveTo(px + dx * from, py + dy * from);
	ctx.lineTo(x, y - 4);
	ctx.stroke();
}
/** Beside the hull, across the track first; then a line further off. */
function placesFor(view, body, width, ringed) {
	const hull = ringed ? ringOf(view, body) : hullOf(view, body);
	const [px, py] = [(hull.x0 + hull.x1) / 2, (hull.y0 + hull.y1) / 2];
	const above = {
		x: px,
		y: hull.y0 - 7
	};
	const below = {
		x: px,
		y: hull.y1 + 15
	};
	const right = {
		x: hull.x1 + 5 + width / 2,
		y: py + 4
	};
	const left = {
		x: hull.x0 - 5 - width / 2,
		y: py + 4
	};
	const near = Math.abs(Math.sin(body.spot.angle)) > .7 ? [
		right,
		left,
		above,
		below
	] : [
		above,
		below,
		right,
		left
	];
	const further = [-15, LINE].map((off) => ({
		x: px,
		y: off < 0 ? above.y + off : below.y + off
	}));
	const aslant = [right.x, left.x].flatMap((x) => [above.y, below.y].map((y) => ({
		x,
		y
	})));
	return [
		...near,
		...further,
		...aslant
	];
}
// src/paint/over.ts
/** The track that vehicles hold ahead. One path a look, since there are many; those that are looked at stand out. */
function paintGrants(ctx, view, track, bodies, strong) {
	const groups = /* @__PURE__ */ new Map();
	const width = Math.min(6, Math.max(view.scale < .011 ? 1.4 : 2, 110 * view.scale));
	ctx.lineCap = "round";
	ctx.lineJoin = "round";
	for (const body of bodies) {
		const ways = granted(track, body);
		if (ways.length === 0 || !ways.some((way) => view.sees(way.box))) continue;
		if (strong(body)) {
			ctx.strokeStyle = LOOK_INK[body.look];
			ctx.globalAlpha = .8;
			stroke(ctx, view, ways, width + 2);
		} else groups.set(body.look, [...groups.get(body.look) ?? [], ...ways]);
	}
	ctx.globalAlpha = .38;
	for (const [look, ways] of groups) {
		ctx.strokeStyle = LOOK_INK[look];
		stroke(ctx, view, ways, width);
	}
	ctx.globalAlpha = 1;
}
function granted(track, { vehicle }) {
	const ways = [];
	let here = vehicle.barcode ?? "";
	for (const step of vehicle.granted) {
		const way = track.way(here, step);
		if (way) ways.push(way);
		here = step;
	}
	return ways;
}
/** Where the chosen vehicle would go from the end of its grant: dashed, since nobody has granted it. */
function paintPlan(ctx, view, track, path) {
	const ways = path.slice(1).flatMap((end, i) => track.way(path[i], end) ?? []);
	ctx.strokeStyle = INK.plan;
	ctx.lineCap = "butt";
	ctx.globalAlpha = .85;
	ctx.setLineDash([7, 5]);
	stroke(ctx, view, ways, Math.max(2, Math.min(3.5, 90 * view.scale)));
	ctx.setLineDash([]);
	ctx.globalAlpha = 1;
}
/** The track behind each barcode in the colour of how much was waited, or how many came by. */
function paintHeat(ctx, view, track, heat, kind) {
	const steps = HEAT.map(() => []);
	for (const [barcode, share] of heat.shares(kind)) {
		const step = Math.min(HEAT.length - 1, Math.floor(share * HEAT.length));
		for (const edge of track.before.get(barcode) ?? []) {
			const way = track.way(edge.start, edge.end);
			if (way && view.sees(way.box)) steps[step]?.push(way);
		}
	}
	ctx.lineCap = "round";
	ctx.globalAlpha = .85;
	steps.forEach((ways, i) => {
		ctx.strokeStyle = HEAT[i];
		stroke(ctx, view, ways, Math.max(3 + i, 330 * view.scale));
	});
	ctx.globalAlpha = 1;
}
/** Closed track: crossed out, so that it is seen without its colour. */
function paintClosed(ctx, view, track, ways) {
	ctx.strokeStyle = INK.closed;
	ctx.lineCap = "butt";
	ctx.globalAlpha = .9;
	stroke(ctx, view, ways, Math.max(3, 200 * view.scale));
	ctx.globalAlpha = 1;
	ctx.lineWidth = 1.6;
	ctx.beginPath();
	let last = -1e3;
	for (const way of ways) {
		const { x, y } = track.along(way, way.edge.length / 2);
		const [px, py] = [view.px(x), view.py(y)];
		if (Math.abs(px + py - last) < 18) continue;
		last = px + py;
		ctx.moveTo(px - 6, py - 6);
		ctx.lineTo(px + 6, py + 6);
		ctx.moveTo(px + 6, py - 6);
		ctx.lineTo(px - 6, py + 6);
	}
	ctx.stroke();
}
/** Vehicles that people have stopped or locked out: a bracket around each. */
function paintHolds(ctx, view, bodies) {
	ctx.lineWidth = 2;
	ctx.strokeStyle = LOOK_INK.held;
	ctx.beginPath();
	for (const body of bodies) {
		if (!visible(view, body) || !(body.vehicle.hold || body.vehicle.lockout)) continue;
		const [px, py] = [view.px(body.spot.x), view.py(body.spot.y)];
		const r = Math.max(10, 900 * view.scale);
		for (const side of [-1, 1]) {
			ctx.moveTo(px + side * r * .5, py - r);
			ctx.lineTo(px + side * r, py - r);
			ctx.lineTo(px + side * r, py + r);
			ctx.lineTo(px + side * r * .5, py + r);
		}
	}
	ctx.stroke();
}
/** Track that somebody thinks of closing. */
function paintPreviewed(ctx, view, ways) {
	ctx.strokeStyle = INK.closed;
	ctx.lineCap = "butt";
	ctx.setLineDash([5, 4]);
	stroke(ctx, view, ways, Math.max(4, 260 * view.scale));
	ctx.setLineDash([]);
}
// src/plan.ts
/** The way that the chosen vehicle would be led to its goal now: asked of the server when it changes goal or leaves that way. */
/** Barcodes from the vehicle to its goal; empty: none is known. */
var plan = y$1([]);
var asked = "";
async function ask(vehicle, from, to) {
	const now = `${vehicle} ${to}`;
	if (asked === now && plan.value.includes(from)) return;
	asked = now;
	try {
		const { items } = await get(`/layout/routes?${new URLSearchParams({
			from,
			to
		})}`);
		if (asked === now) plan.value = items[0]?.barcodes ?? [];
	} catch {
		if (asked === now) plan.value = [];
	}
}
/** Keep it up to date; returns how to stop. */
function begin() {
	return x(() => {
		const pick = inPast.value ? null : selected.value;
		changes.vehicles.value;
		const vehicle = pick?.kind === "vehicle" ? vehicles.get(pick.id) : void 0;
		const goal = vehicle?.goal ? stations.get(vehicle.goal)?.barcode ?? vehicle.goal : null;
		if (vehicle?.barcode && goal && goal !== vehicle.barcode) ask(vehicle.id, vehicle.barcode, goal);
		else {
			asked = "";
			if (plan.peek().length > 0) plan.value = [];
		}
	});
}
// src/view.ts
var FURTHEST_IN = .4;
var View = class {
	scale = .03;
	x = 0;
	y = 0;
	/** Until somebody moves the view, it keeps showing everything. */
	fitted = true;
	width = 1;
	height = 1;
	fit(box, margin) {
		const [w, h] = [Math.max(box.x1 - box.x0, 1e3), Math.max(box.y1 - box.y0, 1e3)];
		const [roomX, roomY] = [this.width - 2 * margin.side, this.height - margin.top - margin.bottom];
		this.scale = Math.max(1e-5, Math.min(roomX / w, roomY / h, .2));
		this.x = margin.side + (roomX - w * this.scale) / 2 - box.x0 * this.scale;
		this.y = margin.top + (roomY - h * this.scale) / 2 - box.y0 * this.scale;
		this.fitted = true;
	}
	zoom(factor, px, py) {
		const next = Math.min(FURTHEST_IN, Math.max(5e-4, this.scale * factor));
		const [mx, my] = [(px - this.x) / this.scale, (py - this.y) / this.scale];
		this.scale = next;
		this.x = px - mx * next;
		this.y = py - my * next;
		this.fitted = false;
	}
	pan(dx, dy) {
		this.x += dx;
		this.y += dy;
		this.fitted = false;
	}
	centre(mx, my) {
		this.x = this.width / 2 - mx * this.scale;
		this.y = this.height / 2 - my * this.scale;
		this.fitted = false;
	}
	px(mx) {
		return mx * this.scale + this.x;
	}
	py(my) {
		return my * this.scale + this.y;
	}
	/** Whether anything of a box in mm may be seen, or lies so many px beside the edge. */
	sees(box, beside = 40) {
		return this.px(box.x1) > -beside && this.py(box.y1) > -beside && this.px(box.x0) < this.width + beside && this.py(box.y0) < this.height + beside;
	}
};
// src/sheet.ts
/** A canvas larger than the map: shifted with the view while somebody moves it, and painted anew only when it has to be. */
/** After a zoom it is blurred for at most so long, ms. */
var BLURRED = 140;
var Sheet = class {
	canvas;
	margin;
	ctx;
	at = new View();
	ratio = 1;
	since = 0;
	/** `margin`: painted beyond each edge of the map, px. */
	constructor(canvas, margin) {
		this.canvas = canvas;
		this.margin = margin;
		this.ctx = canvas.getContext("2d");
		canvas.style.transformOrigin = "0 0";
	}
	resize(width, height, ratio) {
		const { margin } = this;
		const [w, h] = [width + 2 * margin, height + 2 * margin];
		this.ratio = ratio;
		this.canvas.width = Math.round(w * ratio);
		this.canvas.height = Math.round(h * ratio);
		Object.assign(this.canvas.style, {
			left: `${-margin}px`,
			top: `${-margin}px`,
			width: `${w}px`,
			height: `${h}px`
		});
		this.at.scale = 0;
	}
	/** Shift to where the view is. False: it does not show all of it, or not sharply any more. */
	follow(view, now) {
		if (this.at.scale === 0) return false;
		const { margin } = this;
		const k = view.scale / this.at.scale;
		const [dx, dy] = [view.x + margin - k * this.at.x, view.y + margin - k * this.at.y];
		this.canvas.style.transform = k === 1 ? `translate(${dx}px, ${dy}px)` : `translate(${dx}px, ${dy}px) scale(${k})`;
		if (k === 1) this.since = now;
		const [left, top] = [dx - margin, dy - margin];
		const [right, bottom] = [left + k * (view.width + 2 * margin), top + k * (view.height + 2 * margin)];
		return left <= 0 && top <= 0 && right >= view.width && bottom >= view.height && (k === 1 || now - this.since < BLURRED);
	}
	/** Whether it is shown larger or smaller than painted, and will have to be painted anew soon. */
	get blurred() {
		return this.canvas.style.transform.includes("scale");
	}
	/** An empty sheet for this view: paint it in the view that is returned. */
	begin(view, now) {
		const { at, margin } = this;
		Object.assign(at, {
			scale: view.scale,
			x: view.x + margin,
			y: view.y + margin
		});
		Object.assign(at, {
			width: view.width + 2 * margin,
			height: view.height + 2 * margin
		});
		this.ctx.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
		this.ctx.clearRect(0, 0, at.width, at.height);
		this.since = now;
		this.canvas.style.transform = "translate(0px, 0px)";
		return at;
	}
};
// src/painter.ts
/** The live map: what stands still and what lies over it on sheets that are shifted, and what moves on a canvas of its own. */
/** Room in px beyond the outermost marks: buttons and names. */
var MARGIN = {
	top: 66,
	side: 72,
	bottom: 58
};
/** Vehicles are drawn anew at most and at least so often, ms: the map is shifted between, as often as the screen wants. */
var PERIOD = 30;
var SELDOM = 120;
/** The pace by which a vehicle goes across the map, mm/s. */
var FASTEST = 3e3;
/** Below this scale only what is looked at shows its grant: others would be shorter than their vehicles. */
var GRANTS = .008;
/** What lies over the track follows the vehicles so often, ms. */
var OVER = 250;
/** A map that was moved is drawn as often as the screen wants for so long, ms. */
var MOVED = 400;
/** Somebody who looks for one thing sees it at least at this scale. */
var CLOSE = .03;
var STILL = matchMedia("(prefers-reduced-motion: reduce)");
/** Owns the canvases; drawn as often as the screen wants while something moves, and not at all else. */
var Painter = class {
	view = new View();
	hovered = null;
	scene = null;
	glides = /* @__PURE__ */ new Map();
	last = /* @__PURE__ */ new Map();
	signs = new Signs();
	bodies = [];
	names = new Labels();
	specs = /* @__PURE__ */ new Map();
	ground;
	over;
	front;
	/** Of what was seen on this page, and of what was played back. */
	heats = {
		now: new Heat(),
		then: new Heat()
	};
	stale = true;
	overAt = Number.NEGATIVE_INFINITY;
	/** Something was reported since what lies over the track was painted. */
	overStale = true;
	frame = 0;
	painted = 0;
	moved = Number.NEGATIVE_INFINITY;
	namesAt = {
		scale: 0,
		x: 0,
		y: 0
	};
	/** Vehicles in trouble that stand, and where, in words: the names of stations keep clear of them. */
	stranded = [];
	strandedAt = "";
	count = 0;
	constructor(lower, middle, upper) {
		this.ground = new Sheet(lower, 400);
		this.over = new Sheet(middle, 320);
		this.front = new Sheet(upper, 120);
	}
	resize(width, height) {
		const ratio = Math.min(window.devicePixelRatio || 1, 2);
		for (const sheet of [
			this.ground,
			this.over,
			this.front
		]) sheet.resize(width, height, ratio);
		this.view.width = width;
		this.view.height = height;
		if (this.view.fitted) this.fit();
		this.redraw();
	}
	load() {
		if (!layout.value || !track.value) return;
		const clusters = clustersOf(layout.value, track.value);
		const marks = clusters.flatMap((cluster) => cluster.marks);
		const doors = doorMarks(layout.value, track.value);
		this.scene = {
			layout: layout.value,
			track: track.value,
			marks,
			clusters,
			doors
		};
		this.specs = new Map(layout.value.vehicles.map((spec) => [spec.id, spec]));
		this.forgetAll();
		this.heats.now.clear();
		this.fit();
		this.redraw();
	}
	/** Another time is shown: vehicles do not drive from one into the other. */
	forgetAll() {
		this.glides.clear();
		this.last.clear();
		this.heats.then.clear();
		this.redraw();
	}
	fit() {
		if (this.scene) this.view.fit(boxOf(this.scene), MARGIN);
		this.redraw();
	}
	/** Something that stands still has changed. */
	redraw() {
		this.stale = true;
		this.overAt = Number.NEGATIVE_INFINITY;
		this.wake();
	}
	/** Somebody moves the map: it is shifted, and painted anew where that does not do. */
	move() {
		this.moved = performance.now();
		this.wake();
	}
	/** Other colours. */
	recolour() {
		dip();
		this.redraw();
	}
	/** Bring something into the middle. */
	centre({ kind, id }) {
		const spot = this.placeOf(kind, id);
		if (!spot) return;
		this.view.scale = Math.max(this.view.scale, CLOSE);
		this.view.centre(spot.x, spot.y);
		this.move();
	}
	placeOf(kind, id) {
		if (kind === "vehicle") return this.bodies.find((body) => body.vehicle.id === id)?.spot;
		return [...this.scene?.marks ?? [], ...this.scene?.doors ?? []].find((mark) => mark.id === id) ?? this.scene?.track.points.get(id);
	}
	wake() {
		if (!this.frame) this.frame = requestAnimationFrame(() => this.paint());
	}
	stop() {
		cancelAnimationFrame(this.frame);
	}
	/** Take the vehicles' newest reports. */
	report() {
		if (!this.scene) return;
		this.overStale = true;
		const then = inPast.value;
		const now = then ? moment.value : performance.now() / 1e3;
		const heat = then ? this.heats.then : this.heats.now;
		for (const id of this.last.keys()) if (!vehicles.has(id)) this.forget(id);
		for (const vehicle of vehicles.values()) {
			if (this.last.get(vehicle.id) === vehicle) continue;
			this.last.set(vehicle.id, vehicle);
			heat.take(vehicle, now);
			if (then) continue;
			let glide = this.glides.get(vehicle.id);
			if (!glide) {
				glide = new Glide(this.scene.track, this.specs.get(vehicle.id)?.max_speed);
				this.glides.set(vehicle.id, glide);
			}
			const moving = vehicle.link.up && vehicle.activity === "moving";
			const { barcode, dist, granted } = vehicle;
			glide.report({
				barcode,
				dist,
				granted,
				moving
			}, now);
		}
		this.wake();
	}
	at(px, py) {
		let best = null;
		let least = 20;
		for (const body of this.bodies) {
			const away = Math.hypot(this.view.px(body.spot.x) - px, this.view.py(body.spot.y) - py);
			if (away < least) [least, best] = [away, {
				kind: "vehicle",
				id: body.vehicle.id
			}];
		}
		if (best) return best;
		least = wingOf(this.view);
		for (const door of this.scene?.doors ?? []) {
			const away = Math.hypot(this.view.px(door.x) - px, this.view.py(door.y) - py);
			if (away < least) [least, best] = [away, {
				kind: "device",
				id: door.id
			}];
		}
		least = Math.max(9, 330 * this.view.scale);
		for (const mark of this.scene?.marks ?? []) {
			const away = Math.hypot(this.view.px(mark.x) - px, this.view.py(mark.y) - py);
			if (away < least) [least, best] = [away, {
				kind: mark.kind === "charger" ? "device" : "station",
				id: mark.id
			}];
		}
		return best;
	}
	/** The barcode nearest to a place of the map. */
	barcodeAt(px, py) {
		let best = null;
		let least = 25;
		for (const [barcode, { x, y }] of this.scene?.track.points ?? []) {
			const away = Math.hypot(this.view.px(x) - px, this.view.py(y) - py);
			if (away < least) [least, best] = [away, barcode];
		}
		return best;
	}
	forget(id) {
		this.last.delete(id);
		this.glides.delete(id);
	}
	paint() {
		this.frame = 0;
		const { scene, view } = this;
		if (!scene) return;
		const ms = performance.now();
		const moving = ms - this.moved < MOVED;
		const due = ms - this.painted >= this.period() - 5;
		if (!moving && !due) {
			this.wake();
			return;
		}
		const pick = selected.value;
		if (following.value && pick?.kind === "vehicle") this.keepInMiddle(pick.id);
		if (!this.ground.follow(view, ms) || this.stale) this.paintGround(scene, ms);
		if (!this.front.follow(view, ms) || due) this.paintFront(ms);
		if (!this.over.follow(view, ms) || due && ms - this.overAt > OVER) this.paintOver(scene, ms);
		this.front.canvas.dataset["pictures"] = String(++this.count);
		if (inPast.value && !loading.value) this.front.canvas.dataset["moment"] = String(moment.value);
		const alarm = this.bodies.some((body) => body.look === "alarm");
		const drives = inPast.value ? playing.value : [...this.glides.values()].some((glide) => glide.busy);
		if (!STILL.matches && (alarm || drives) || moving || this.stale || this.overStale || [
			this.ground,
			this.over,
			this.front
		].some((sheet) => sheet.blurred)) this.wake();
	}
	/** How long until the fastest vehicle has moved by a pixel: more often nothing would be seen to change, ms. */
	period() {
		return Math.min(SELDOM, Math.max(PERIOD, 1e3 / (FASTEST * (inPast.value ? pace.value : 1) * this.view.scale)));
	}
	looked(body) {
		const pick = selected.value;
		if (pick?.kind === "vehicle" && pick.id === body.vehicle.id) return .95;
		return this.hovered?.kind === "vehicle" && this.hovered.id === body.vehicle.id ? .5 : 0;
	}
	paintFront(ms) {
		this.painted = ms;
		this.bodies = this.placed(ms / 1e3);
		this.strand();
		const at = this.front.begin(this.view, ms);
		const { ctx } = this.front;
		const seen = this.bodies.filter((body) => visible(at, body));
		paintFleet(ctx, at, seen);
		paintRings(ctx, at, seen, (body) => this.looked(body), STILL.matches ? 0 : ms / 1e3 % 1.4 / 1.4);
		const free = (box) => this.names.free(this.onGround(box, at));
		const { margin } = this.front;
		const shown = {
			x0: margin,
			y0: margin,
			x1: at.width - margin,
			y1: at.height - margin
		};
		this.signs.paint(ctx, at, seen, (body) => this.looked(body) > 0, free, shown);
	}
	/** Note which vehicles in trouble stand where; what stands still is painted anew when that changes. */
	strand() {
		this.stranded = this.bodies.filter((body) => urgent(body) && !this.glides.get(body.vehicle.id)?.busy);
		const at = this.stranded.map(({ vehicle, spot }) => `${vehicle.id} ${Math.round(spot.x / 100)} ${Math.round(spot.y / 100)}`).join();
		if (at !== this.strandedAt) this.stale = true;
		this.strandedAt = at;
	}
	paintGround(scene, ms) {
		this.stale = false;
		const pick = selected.value;
		const now = {
			station: (id) => stations.get(id),
			device: (id) => devices.get(id),
			look: lookAt,
			picked: pick?.kind === "station" || pick?.kind === "device" ? pick : null,
			zones: layers.value.zones
		};
		const at = this.ground.begin(this.view, ms);
		this.names = paintPlant(this.ground.ctx, at, scene, now, this.stranded.map((body) => coveredBy(at, body)));
		this.namesAt = {
			scale: at.scale,
			x: at.x,
			y: at.y
		};
	}
	paintOver(scene, ms) {
		this.overAt = ms;
		this.overStale = false;
		const at = this.over.begin(this.view, ms);
		const { ctx } = this.over;
		const { track: drawn } = scene;
		if (heatShown.value) paintHeat(ctx, at, drawn, heatKept.value ?? (inPast.value ? this.heats.then : this.heats.now), heatShown.value);
		if (layers.value.closures) paintClosed(ctx, at, drawn, closedWays.value.flatMap(([start, end]) => drawn.way(start, end) ?? []));
		if (previewedWays.value.length > 0) paintPreviewed(ctx, at, previewedWays.value.flatMap(([start, end]) => drawn.way(start, end) ?? []));
		if (plan.value.length > 0) paintPlan(ctx, at, drawn, plan.value);
		const strong = (body) => this.looked(body) > 0;
		const granted = this.view.scale > GRANTS ? this.bodies : this.bodies.filter(strong);
		if (layers.value.grants) paintGrants(ctx, at, drawn, granted, strong);
		if (layers.value.holds) paintHolds(ctx, at, this.bodies);
	}
	/** Where a box of a view lies on the sheet on which the names stand. */
	onGround({ x0, x1, y0, y1 }, view) {
		const { namesAt } = this;
		const k = namesAt.scale / view.scale;
		const [dx, dy] = [namesAt.x - view.x * k, namesAt.y - view.y * k];
		return {
			x0: x0 * k + dx,
			x1: x1 * k + dx,
			y0: y0 * k + dy,
			y1: y1 * k + dy
		};
	}
	keepInMiddle(id) {
		const spot = this.bodies.find((body) => body.vehicle.id === id)?.spot;
		if (spot) this.view.centre(spot.x, spot.y);
	}
	spotOf({ id, activity }, back, now) {
		if (activity === "off_rail" || !this.scene) return null;
		if (inPast.value) return trails.spot(this.scene.track, id, moment.value, back, STILL.matches);
		return this.glides.get(id)?.drive(now, STILL.matches).middle(back) ?? null;
	}
	placed(now) {
		const bodies = [];
		for (const vehicle of this.last.values()) {
			const spec = this.specs.get(vehicle.id);
			const agv = spec?.kind === "agv";
			const length = Math.min(spec?.length ?? 1e3, 1200);
			const back = agv ? 0 : length * .41;
			const spot = this.spotOf(vehicle, back, now);
			if (spot) bodies.push({
				vehicle,
				look: lookOf(vehicle),
				agv,
				spot,
				length
			});
		}
		return bodies;
	}
};
/** What has to be seen: the track, and the marks beside it. */
function boxOf({ track: drawn, marks }) {
	const box = { ...drawn.box };
	for (const { x, y } of marks) {
		box.x0 = Math.min(box.x0, x - 460);
		box.x1 = Math.max(box.x1, x + 460);
		box.y0 = Math.min(box.y0, y - 460);
		box.y1 = Math.max(box.y1, y + 460);
	}
	return box;
}
// src/find.ts
/** What the page can be asked for by name. */
var MOST = 12;
/** Things whose name has these letters in it, those that begin with them first. */
function find(letters) {
	const wanted = letters.trim().toLowerCase();
	if (!wanted) return [];
	const names = (kind, ids) => [...ids].filter((id) => id.toLowerCase().includes(wanted)).map((id) => ({
		kind,
		id
	}));
	const carried = [...[...vehicles.values()].map(({ id, carrier }) => ({
		kind: "vehicle",
		id,
		carrier
	})), ...[...stations.values()].map(({ id, carrier }) => ({
		kind: "station",
		id,
		carrier
	}))].filter(({ carrier }) => carrier?.toLowerCase().includes(wanted)).map(({ kind, id, carrier }) => ({
		kind,
		id: carrier,
		at: {
			kind,
			id
		}
	}));
	const barcodes = wanted.length > 1 ? names("barcode", (layout.value?.points ?? []).map(({ barcode }) => barcode)) : [];
	const all = [
		...names("vehicle", vehicles.keys()),
		...names("station", stations.keys()),
		...names("job", jobs.keys()),
		...carried,
		...names("device", devices.keys()),
		...names("drive", drives.keys()),
		...barcodes
	];
	const rank = ({ id }) => id.toLowerCase() === wanted ? 0 : id.toLowerCase().startsWith(wanted) ? 1 : 2;
	return all.sort((a, b) => rank(a) - rank(b) || NATURAL.compare(a.id, b.id)).slice(0, MOST);
}
// src/parts/Finder.tsx
/** Finds a vehicle, station, carrier, job, device or barcode by its name, and shows it on the map. */
function Finder({ go }) {
	const letters = useSignal("");
	const which = useSignal(0);
	const box = T(null);
	A$1(() => {
		const key = (event) => {
			if (event.key !== "/" || event.ctrlKey || event.target instanceof HTMLInputElement) return;
			event.preventDefault();
			box.current?.focus();
		};
		document.addEventListener("keydown", key);
		return () => document.removeEventListener("keydown", key);
	}, []);
	const list = find(letters.value);
	const choose = (found) => {
		if (!found) return;
		const pick = found.at ?? (found.kind === "barcode" ? null : {
			kind: found.kind,
			id: found.id
		});
		if (pick) selected.value = pick;
		go(found.at ? {
			kind: found.at.kind,
			id: found.at.id
		} : found);
		letters.value = "";
		box.current?.blur();
	};
	const key = (event) => {
		const step = {
			ArrowDown: 1,
			ArrowUp: -1
		}[event.key];
		if (step) which.value = Math.min(Math.max(which.value + step, 0), list.length - 1);
		else if (event.key === "Enter") choose(list[which.value]);
		else if (event.key === "Escape") letters.value = "";
		else return;
		event.preventDefault();
	};
	return /* @__PURE__ */ a("div", {
		class: "finder",
		children: [/* @__PURE__ */ a("input", {
			ref: box,
			role: "combobox",
			"aria-expanded": list.length > 0,
			"aria-controls": "found",
			"aria-label": t("find"),
			placeholder: `${t("find")}  /`,
			autocomplete: "off",
			value: letters.value,
			onInput: (event) => {
				letters.value = event.currentTarget.value;
				which.value = 0;
			},
			onKeyDown: key
		}), letters.value.trim() && /* @__PURE__ */ a("ul", {
			id: "found",
			role: "listbox",
			"aria-label": t("find"),
			children: [list.map((found, i) => /* @__PURE__ */ a("li", {
				role: "option",
				"aria-selected": i === which.value,
				onPointerDown: (event) => {
					event.preventDefault();
					choose(found);
				},
				children: [found.id, /* @__PURE__ */ a("small", { children: found.at ? `${t("carrier")} · ${found.at.id}` : t(found.kind === "station" ? "at_station" : found.kind) })]
			}, `${found.kind} ${found.id}`)), list.length === 0 && /* @__PURE__ */ a("li", {
				class: "none",
				children: t("nothing_found")
			})]
		})]
	});
}
// src/parts/Keys.tsx
/** The keys that the map takes. */
var KEYS = [
	["/", "key_find"],
	["← ↑ → ↓", "key_pan"],
	["+ −", "key_zoom"],
	["0", "key_fit"],
	["F", "key_follow"],
	["Esc", "key_none"]
];
var PAST_KEYS = [
	["K", "play"],
	[",", "event_before"],
	[".", "event_next"]
];
function Keys$1() {
	const open = useSignal(false);
	return /* @__PURE__ */ a($, { children: [/* @__PURE__ */ a("button", {
		type: "button",
		"aria-label": t("keys"),
		title: t("keys"),
		onClick: () => open.value = true,
		children: "?"
	}), open.value && /* @__PURE__ */ a(List, { close: () => open.value = false })] });
}
function List({ close }) {
	const box = T(null);
	A$1(() => box.current?.showModal(), []);
	return /* @__PURE__ */ a("dialog", {
		ref: box,
		"aria-label": t("keys"),
		onClose: close,
		children: /* @__PURE__ */ a("form", {
			method: "dialog",
			children: [
				/* @__PURE__ */ a("h2", { children: t("keys") }),
				/* @__PURE__ */ a("dl", {
					class: "keys",
					children: KEYS.map(([key, word]) => /* @__PURE__ */ a("div", { children: [/* @__PURE__ */ a("dt", { children: /* @__PURE__ */ a("kbd", { children: key }) }), /* @__PURE__ */ a("dd", { children: t(word) })] }, key))
				}),
				inPast.value && /* @__PURE__ */ a($, { children: [/* @__PURE__ */ a("h2", { children: t("keys_past") }), /* @__PURE__ */ a("dl", {
					class: "keys",
					children: PAST_KEYS.map(([key, word]) => /* @__PURE__ */ a("div", { children: [/* @__PURE__ */ a("dt", { children: /* @__PURE__ */ a("kbd", { children: key }) }), /* @__PURE__ */ a("dd", { children: t(word) })] }, key))
				})] }),
				/* @__PURE__ */ a("button", {
					type: "submit",
					children: t("close")
				})
			]
		})
	});
}
// src/parts/Layers.tsx
/** Which layers the map shows. */
var HEATS = [
	null,
	"waiting",
	"traffic"
];
function Layers() {
	const open = useSignal(false);
	return /* @__PURE__ */ a("div", {
		...useClosed(open),
		class: "layers",
		children: [/* @__PURE__ */ a("button", {
			type: "button",
			"aria-expanded": open.value,
			onClick: () => open.value = !open.value,
			children: t("layers")
		}), open.value && /* @__PURE__ */ a("div", {
			role: "group",
			"aria-label": t("layers"),
			children: [
				LAYERS.map((layer) => /* @__PURE__ */ a("label", { children: [/* @__PURE__ */ a("input", {
					type: "checkbox",
					checked: layers.value[layer],
					onChange: (event) => show(layer, event.currentTarget.checked)
				}), t(`layer_${layer}`)] }, layer)),
				/* @__PURE__ */ a("b", { children: t("heat") }),
				HEATS.map((kind) => /* @__PURE__ */ a("label", { children: [/* @__PURE__ */ a("input", {
					type: "radio",
					name: "heat",
					checked: heatShown.value === kind,
					onChange: () => heatShown.value = kind
				}), t(kind === null ? "heat_off" : kind === "waiting" ? "heat_waiting" : "heat_traffic")] }, kind ?? "off")),
				heatShown.value && /* @__PURE__ */ a("label", { children: [t("heat_over"), /* @__PURE__ */ a("select", {
					value: heatHours.value,
					onChange: (event) => heatHours.value = Number(event.currentTarget.value),
					children: HEAT_HOURS.map((hours) => /* @__PURE__ */ a("option", {
						value: hours,
						children: hours ? t("heat_hours", hours) : t("heat_seen")
					}, hours))
				})] })
			]
		})]
	});
}
// src/parts/Legend.tsx
/** What the colours and forms on the map mean; what the plant does not have is left out. */
function Legend() {
	const plant = layout.value;
	const agvs = plant?.vehicles.some((vehicle) => vehicle.kind === "agv") ?? false;
	const looks = Object.keys(LOOKS).filter((look) => look !== "charging" || agvs);
	const zones = layers.value.zones ? plant?.zones ?? [] : [];
	return /* @__PURE__ */ a("div", {
		class: "legend",
		children: [
			looks.map((look) => /* @__PURE__ */ a("span", { children: [
				/* @__PURE__ */ a("i", {
					class: "dot",
					style: { background: LOOKS[look] }
				}),
				t(`look_${look}`),
				" ",
				SIGNS[look]
			] }, look)),
			/* @__PURE__ */ a("span", { children: [/* @__PURE__ */ a("i", {
				class: "mark-unknown",
				children: "?"
			}), t("legend_unknown")] }),
			/* @__PURE__ */ a("span", { children: [/* @__PURE__ */ a("i", { class: "box" }), t("legend_carrier")] }),
			layers.value.grants && /* @__PURE__ */ a("span", { children: [/* @__PURE__ */ a("i", { class: "path granted" }), t("legend_granted")] }),
			plan.value.length > 0 && /* @__PURE__ */ a("span", { children: [/* @__PURE__ */ a("i", { class: "path planned" }), t("legend_planned")] }),
			layers.value.closures && closedWays.value.length > 0 && /* @__PURE__ */ a("span", { children: [/* @__PURE__ */ a("i", {
				class: "path closed",
				children: "×"
			}), t("closed")] }),
			zones.some((zone) => zone.no_stop && !zone.soft) && /* @__PURE__ */ a("span", { children: [/* @__PURE__ */ a("i", { class: "zone" }), t("legend_zone")] }),
			zones.some((zone) => zone.soft) && /* @__PURE__ */ a("span", { children: [/* @__PURE__ */ a("i", { class: "zone soft" }), t("legend_soft")] }),
			plant && plant.doors.length > 0 && /* @__PURE__ */ a("span", { children: [
				/* @__PURE__ */ a("i", { class: "door shut" }),
				/* @__PURE__ */ a("i", { class: "door ajar" }),
				t("legend_door")
			] }),
			plant && plant.chargers.length > 0 && /* @__PURE__ */ a("span", { children: [/* @__PURE__ */ a("i", {
				class: "flash",
				children: "↯"
			}), t("charger")] }),
			heatShown.value && /* @__PURE__ */ a("span", {
				class: "heat-key",
				children: [
					t(heatShown.value === "waiting" ? "heat_waiting" : "heat_traffic"),
					": ",
					t("little"),
					[
						1,
						2,
						3,
						4,
						5,
						6
					].map((step) => /* @__PURE__ */ a("i", { style: { background: `var(--heat-${step})` } }, step)),
					t("much")
				]
			})
		]
	});
}
// src/parts/TrackMap.tsx
/** The live map with its buttons, its legend, and what is said of the thing under the pointer. */
function tipOf(hit, x, y) {
	const lines = hit && linesFor(hit.kind, hit.id);
	return lines ? {
		x,
		y,
		title: hit.id,
		lines: lines.filter(Boolean)
	} : null;
}
function linesFor(kind, id) {
	if (kind === "vehicle") {
		const vehicle = vehicles.get(id);
		if (!vehicle) return null;
		const load = vehicle.loaded ? vehicle.carrier ?? t("loaded") : t("empty");
		return [
			`${said$1(vehicle.activity)} · ${load}`,
			tell(vehicle.waiting),
			tell(vehicle.hold?.reason ?? "")
		];
	}
	if (kind === "device") {
		const device = devices.get(id);
		const charger = layout.value?.chargers.some((one) => one.id === id);
		return [
			`${t(charger ? "charger" : "door")} · ${t(`device_${lookAt(id)}`)}`,
			tell(device?.alarm || device?.reason || ""),
			passers(id).join(", ")
		];
	}
	const station = stations.get(id);
	if (!station) return null;
	const content = station.present === null ? t("unknown") : station.present ? station.carrier ?? t("loaded") : t("empty");
	const name = layout.value?.stations.find((one) => one.id === id)?.buffer;
	const buffer = name ? devices.get(name) : void 0;
	return [`${said$1(station.kind)} · ${content}`, buffer ? `${buffer.id} · ${t(`device_${lookAt(buffer.id)}`)}` : ""];
}
function TrackMap() {
	const frame = T(null);
	const lower = T(null);
	const middle = T(null);
	const upper = T(null);
	const touch = T(null);
	const painter = T(null);
	const tip = useSignal(null);
	A$1(() => {
		const box = frame.current;
		const paint = new Painter(lower.current, middle.current, upper.current);
		painter.current = paint;
		const size = new ResizeObserver(() => paint.resize(box.clientWidth, box.clientHeight));
		size.observe(box);
		const stops = [
			begin(),
			begin$1(),
			x(() => {
				track.value;
				paint.load();
			}),
			x(() => {
				changes.vehicles.value;
				track.value;
				paint.report();
			}),
			x(() => {
				changes.stations.value;
				changes.devices.value;
				presence.value;
				selected.value;
				layers.value;
				heatShown.value;
				heatKept.value;
				closedWays.value;
				previewedWays.value;
				plan.value;
				paint.redraw();
			}),
			x(() => {
				theme.value;
				paint.recolour();
			}),
			x(() => {
				inPast.value;
				paint.forgetAll();
				paint.report();
			}),
			x(() => {
				moment.value;
				paint.wake();
			}),
			x(() => {
				following.value;
				paint.move();
			}),
			listenTo(touch.current, paint, (hit, x, y) => tip.value = tipOf(hit, x, y))
		];
		return () => {
			size.disconnect();
			for (const stop of stops) stop();
			paint.stop();
		};
	}, []);
	const zoom = (factor) => {
		const paint = painter.current;
		paint?.view.zoom(factor, paint.view.width / 2, paint.view.height / 2);
		paint?.move();
	};
	const go = (found) => {
		if (found.kind !== "barcode") painter.current?.centre({
			kind: found.kind,
			id: found.id
		});
		else painter.current?.centre({
			kind: "station",
			id: found.id
		});
	};
	const pick = selected.value;
	return /* @__PURE__ */ a("div", {
		class: "map",
		ref: frame,
		children: [
			/* @__PURE__ */ a("canvas", {
				ref: lower,
				"aria-hidden": "true"
			}),
			/* @__PURE__ */ a("canvas", {
				ref: middle,
				"aria-hidden": "true"
			}),
			/* @__PURE__ */ a("canvas", {
				ref: upper,
				class: "front",
				"aria-hidden": "true"
			}),
			/* @__PURE__ */ a("div", {
				ref: touch,
				class: "touch",
				tabIndex: 0,
				role: "application",
				"aria-label": t("map_label")
			}),
			/* @__PURE__ */ a("div", {
				class: "map-tools",
				children: [
					/* @__PURE__ */ a("button", {
						type: "button",
						onClick: () => zoom(1.4),
						"aria-label": t("zoom_in"),
						title: t("zoom_in"),
						children: "+"
					}),
					/* @__PURE__ */ a("button", {
						type: "button",
						onClick: () => zoom(1 / 1.4),
						"aria-label": t("zoom_out"),
						title: t("zoom_out"),
						children: "−"
					}),
					/* @__PURE__ */ a("button", {
						type: "button",
						onClick: () => painter.current?.fit(),
						children: t("fit")
					}),
					/* @__PURE__ */ a("button", {
						type: "button",
						"aria-pressed": following.value,
						disabled: pick?.kind !== "vehicle",
						title: t("follow_hint"),
						onClick: () => following.value = !following.value,
						children: t("follow")
					}),
					/* @__PURE__ */ a(Layers, {}),
					/* @__PURE__ */ a(Finder, { go }),
					/* @__PURE__ */ a(Keys$1, {})
				]
			}),
			/* @__PURE__ */ a(Legend, {}),
			tip.value && /* @__PURE__ */ a("div", {
				class: "tip",
				style: {
					left: `${tip.value.x}px`,
					top: `${tip.value.y}px`
				},
				children: [/* @__PURE__ */ a("b", { children: tip.value.title }), tip.value.lines.map((line) => /* @__PURE__ */ a("div", { children: line }, line))]
			})
		]
	});
}
// src/parts/VehicleStrip.tsx
/** All vehicles at a glance, reachable by key; how many do what where there are too many. */
var CHIPS = 40;
function VehicleStrip() {
	const list = vehicleList.value;
	const pick = selected.value?.kind === "vehicle" ? selected.value.id : "";
	if (list.length > CHIPS) return /* @__PURE__ */ a(Groups, {});
	const unknown = none("");
	if (list.length === 0 && unknown) return /* @__PURE__ */ a("p", {
		class: "strip nothing",
		children: unknown
	});
	return /* @__PURE__ */ a("nav", {
		class: "strip",
		"aria-label": t("vehicles"),
		children: list.map((vehicle) => {
			const look = lookOf(vehicle);
			return /* @__PURE__ */ a("button", {
				type: "button",
				class: "chip",
				"aria-pressed": pick === vehicle.id,
				style: { "--look": LOOKS[look] },
				title: tell(vehicle.waiting || vehicle.hold?.reason || ""),
				onClick: () => choose(pick === vehicle.id ? "" : vehicle.id),
				children: [/* @__PURE__ */ a("b", { children: [vehicle.id, vehicle.loaded && /* @__PURE__ */ a("i", { class: "box" })] }), /* @__PURE__ */ a("small", { children: look === "gone" ? t("look_gone") : doing(vehicle) })]
			}, vehicle.id);
		})
	});
}
/** A fleet too large for a chip each: how many look how; the rest is in the room of vehicles. */
function Groups() {
	const counts = /* @__PURE__ */ new Map();
	for (const vehicle of vehicleList.value) counts.set(lookOf(vehicle), (counts.get(lookOf(vehicle)) ?? 0) + 1);
	return /* @__PURE__ */ a("nav", {
		class: "strip",
		"aria-label": t("vehicles"),
		children: Object.keys(LOOKS).map((look) => counts.has(look) && /* @__PURE__ */ a("button", {
			type: "button",
			class: "chip",
			style: { "--look": LOOKS[look] },
			onClick: () => room$1.value = "vehicles",
			children: [/* @__PURE__ */ a("b", { children: counts.get(look) }), /* @__PURE__ */ a("small", { children: t(`look_${look}`) })]
		}, look))
	});
}
function choose(id) {
	selected.value = id ? {
		kind: "vehicle",
		id
	} : null;
}
// src/parts/Playback.tsx
/** The plant as it was: the same map at a moment of the past, and how to move through the time that was recorded. */
function Playback() {
	return /* @__PURE__ */ a("div", {
		class: "plan then",
		children: [
			/* @__PURE__ */ a(VehicleStrip, {}),
			/* @__PURE__ */ a("div", {
				class: "stage",
				children: [/* @__PURE__ */ a(PastBanner, {}), /* @__PURE__ */ a(TrackMap, {})]
			}),
			/* @__PURE__ */ a("section", {
				class: "card transport",
				"aria-label": t("playback"),
				children: [/* @__PURE__ */ a(Problem, { error: error.value }), kept$1.value && told.value > 0 ? /* @__PURE__ */ a(Scrubber, {}) : /* @__PURE__ */ a("p", {
					class: "nothing",
					children: looked.value ? kept$1.value ? t("loading") : t("nothing_recorded") : t("not_known_yet")
				})]
			})
		]
	});
}
/** Day and time of day at this place. */
function dated(seconds) {
	const at = /* @__PURE__ */ new Date(seconds * 1e3);
	return `${[
		at.getFullYear(),
		at.getMonth() + 1,
		at.getDate()
	].map((part) => String(part).padStart(2, "0")).join("-")} ${clock(at.toISOString())}`;
}
/** Says that this is the past, for as long as it is, and leads back. */
function PastBanner() {
	tick.value;
	const incident = kept$1.value?.incident;
	const at = told.value;
	const ago = Math.max(0, serverNow() / 1e3 - at);
	const grave = alarmCount.value;
	return /* @__PURE__ */ a("div", {
		class: "past-banner",
		role: "status",
		"aria-live": "off",
		children: [
			/* @__PURE__ */ a("b", { children: t(recording.value ? "past_recording" : "past_here") }),
			at > 0 && /* @__PURE__ */ a("time", {
				class: "then-at",
				children: dated(at)
			}),
			at > 0 && !recording.value && /* @__PURE__ */ a("span", { children: t("past_ago", span(ago * 1e3)) }),
			incident && /* @__PURE__ */ a("span", { children: t("past_by", incident.by, `${incident.made.slice(0, 10)} ${clock(incident.made)}`) }),
			/* @__PURE__ */ a("span", { children: t("past_no_commands") }),
			loading.value && /* @__PURE__ */ a("span", { children: t("loading") }),
			/* @__PURE__ */ a("span", { class: "grow" }),
			grave > 0 && !recording.value && /* @__PURE__ */ a("b", {
				class: "bad",
				children: ["! ", t("past_alarms_now", grave)]
			}),
			!recording.value && /* @__PURE__ */ a("button", {
				type: "button",
				class: "primary",
				onClick: () => room$1.value = "map",
				children: t("back_to_live")
			})
		]
	});
}
/** What to look for in the stretch of time that is drawn; each leads to its moment. */
function PastEvents() {
	const list = marks.value.toReversed();
	const ahead = useComputed(() => marks.value.filter((event) => Date.parse(event.ts) / 1e3 > told.value).length).value;
	A$1(() => {
		document.querySelector(`[data-mark="${stepped.value?.seq}"]`)?.scrollIntoView({ block: "nearest" });
	}, [stepped.value]);
	return /* @__PURE__ */ a("section", {
		class: "card past-events",
		"aria-label": t("events_of_note"),
		children: [/* @__PURE__ */ a("h2", { children: [
			t("events_of_note"),
			" ",
			/* @__PURE__ */ a("small", {
				class: "calm",
				children: list.length
			})
		] }), /* @__PURE__ */ a("ol", {
			class: "scroll",
			reversed: true,
			tabIndex: 0,
			"aria-label": t("events_of_note"),
			children: [list.length === 0 && /* @__PURE__ */ a("li", {
				class: "nothing",
				children: none(t("no_marks"))
			}), list.map((event, i) => /* @__PURE__ */ a(Line, {
				event,
				past: i >= ahead
			}, event.seq))]
		})]
	});
}
/** The drive or device that an event without a vehicle is about, if it is about one. */
function machineOf(id) {
	const plant = layout.value;
	if (plant?.drives?.some((drive) => drive.id === id)) return {
		kind: "drive",
		id
	};
	return [...plant?.doors ?? [], ...plant?.chargers ?? []].some((one) => one.id === id) ? {
		kind: "device",
		id
	} : null;
}
function Line({ event, past }) {
	const kind = kindOf(event.event);
	const go = () => {
		const machine = machineOf(event.source);
		if (event.vehicle) selected.value = {
			kind: "vehicle",
			id: event.vehicle
		};
		else if (machine) selected.value = machine;
		goTo(event);
	};
	return /* @__PURE__ */ a("li", {
		"data-mark": event.seq,
		class: past ? "" : "ahead",
		"aria-current": stepped.value?.seq === event.seq ? "true" : void 0,
		children: /* @__PURE__ */ a("button", {
			type: "button",
			class: "text",
			onClick: go,
			children: [
				/* @__PURE__ */ a("i", {
					class: `mark ${kind}`,
					"aria-hidden": "true"
				}),
				" ",
				/* @__PURE__ */ a("time", { children: clock(event.ts) }),
				" ",
				/* @__PURE__ */ a("b", { children: happening(event.event) }),
				" ",
				[
					event.vehicle,
					event.source,
					tell(event.detail || event.result)
				].filter(Boolean).join(" · ")
			]
		})
	});
}
// src/parts/Stage.tsx
/** Sends a vehicle to a station before its lot is ready; it stays idle there. */
function Stage({ id }) {
	const vehicle = useSignal("");
	const asking = useAsking();
	const send = () => void asking.ask(async () => {
		const body = vehicle.value.trim() ? { vehicle: vehicle.value.trim() } : {};
		const sent = await post(`/stations/${encodeURIComponent(id)}/stage`, body);
		vehicle.value = sent.id;
	}, t("staged"));
	return /* @__PURE__ */ a("details", {
		class: "part acts",
		children: [
			/* @__PURE__ */ a("summary", { children: t("stage") }),
			/* @__PURE__ */ a("div", {
				class: "fields",
				children: [/* @__PURE__ */ a(Field, {
					label: t("vehicle"),
					name: "stage",
					value: vehicle,
					list: "stage-vehicles",
					hint: t("nearest_free")
				}), /* @__PURE__ */ a("div", {
					class: "acts-row",
					children: /* @__PURE__ */ a(Sure, {
						needs: "POST /stations/{station}/stage",
						label: t("stage"),
						does: send
					})
				})]
			}),
			/* @__PURE__ */ a("datalist", {
				id: "stage-vehicles",
				children: layout.value?.vehicles.map((one) => /* @__PURE__ */ a("option", { value: one.id }, one.id))
			}),
			/* @__PURE__ */ a(Told, { asking })
		]
	});
}
// src/parts/StationWrite.tsx
/** A person writes down what is at a station, or that it is not to be used. */
var KNOWN = {
	yes: true,
	no: false,
	unknown: null
};
function StationWrite({ station }) {
	const present = useSignal(station.present === null ? "unknown" : station.present ? "yes" : "no");
	const carrier = useSignal(station.carrier ?? "");
	const reserved = useSignal(station.reserved);
	const closed = useSignal(station.out_of_service);
	const asking = useAsking();
	const send = (event) => {
		event.preventDefault();
		const body = {
			present: KNOWN[present.value],
			carrier: present.value === "yes" ? carrier.value.trim() : "",
			reserved: reserved.value.trim(),
			out_of_service: closed.value.trim(),
			by_person: true
		};
		asking.ask(() => call("PATCH", `/stations/${encodeURIComponent(station.id)}`, body));
	};
	return /* @__PURE__ */ a("details", {
		class: "part acts",
		children: [/* @__PURE__ */ a("summary", { children: t("write_down") }), /* @__PURE__ */ a("form", {
			class: "stack",
			onSubmit: send,
			children: [
				/* @__PURE__ */ a("div", {
					class: "fields",
					children: [
						/* @__PURE__ */ a(Choice$1, {
							label: t("present"),
							value: present,
							of: [
								["yes", t("yes")],
								["no", t("no")],
								["unknown", t("unknown")]
							]
						}),
						/* @__PURE__ */ a(Field, {
							label: t("carrier"),
							name: "carrier",
							value: carrier,
							hint: t("unknown")
						}),
						/* @__PURE__ */ a(Field, {
							label: t("reserved"),
							name: "reserved",
							value: reserved,
							hint: t("no")
						}),
						/* @__PURE__ */ a(Field, {
							label: t("out_of_service"),
							name: "out_of_service",
							value: closed,
							hint: t("no")
						})
					]
				}),
				/* @__PURE__ */ a("div", {
					class: "acts-row",
					children: /* @__PURE__ */ a(Button, {
						needs: "PATCH /stations/{station}",
						type: "submit",
						children: t("write_down")
					})
				}),
				/* @__PURE__ */ a(Told, { asking })
			]
		})]
	});
}
// src/parts/StationPanel.tsx
function StationPanel({ id }) {
	const now = stationNow(id);
	tick.value;
	if (!now) return /* @__PURE__ */ a(Missing, { id });
	const buffer = layout.value?.stations.find((station) => station.id === id)?.buffer;
	const occupied = now.present === null ? t("unknown") : now.present ? t("yes") : t("no");
	return /* @__PURE__ */ a(Panel, {
		title: now.id,
		tag: said$1(now.kind),
		colour: now.present ? "var(--ink-carrier)" : "var(--ink-mark)",
		children: [
			/* @__PURE__ */ a(CutOff, { id }),
			/* @__PURE__ */ a("dl", { children: [
				/* @__PURE__ */ a(Fact, {
					name: t("present"),
					children: [
						occupied,
						" ",
						/* @__PURE__ */ a("small", { children: [
							"(",
							now.verified ? t("verified") : t("believed"),
							")"
						] })
					]
				}),
				/* @__PURE__ */ a(Fact, {
					name: t("carrier"),
					children: now.carrier ?? t("none")
				}),
				/* @__PURE__ */ a(Fact, {
					name: t("provenance"),
					children: [said$1(now.provenance), now.at && /* @__PURE__ */ a("small", { children: [" · ", t("ago", span(serverNow() - Date.parse(now.at)))] })]
				}),
				/* @__PURE__ */ a(Fact, {
					name: t("reserved"),
					children: now.reserved || t("no")
				}),
				/* @__PURE__ */ a(Fact, {
					name: t("out_of_service"),
					children: now.out_of_service || t("no")
				}),
				/* @__PURE__ */ a(Fact, {
					name: t("barcode"),
					children: now.barcode
				}),
				now.target && /* @__PURE__ */ a(Fact, {
					name: t("target"),
					children: [
						"SHFT ",
						now.target[0],
						" · ROTA ",
						now.target[1],
						" · LIFT ",
						now.target[2],
						" ",
						/* @__PURE__ */ a("small", { children: ["v", now.target_version] })
					]
				})
			] }),
			/* @__PURE__ */ a("div", {
				class: "buttons",
				children: [/* @__PURE__ */ a("button", {
					type: "button",
					onClick: () => orderFrom(id),
					children: t("use_source")
				}), /* @__PURE__ */ a("button", {
					type: "button",
					onClick: () => orderTo(id),
					children: t("use_destination")
				})]
			}),
			/* @__PURE__ */ a(Stage, { id }),
			/* @__PURE__ */ a(StationWrite, { station: now }, `${now.id} ${now.at}`),
			now.kind === "port" && /* @__PURE__ */ a(Taught, {
				kind: "station",
				id
			}),
			buffer && /* @__PURE__ */ a("section", {
				class: "part",
				children: [/* @__PURE__ */ a("h3", { children: [
					t("buffer"),
					" ",
					buffer
				] }), /* @__PURE__ */ a(DeviceBody, { id: buffer })]
			})
		]
	});
}
// src/parts/Once.tsx
/** Something that is shown once and never again: a key, a secret; it is copied and put away. */
function Once({ label, value }) {
	const box = T(null);
	const copied = useSignal(false);
	if (!value.value) return null;
	const copy = async () => {
		box.current?.select();
		try {
			await navigator.clipboard.writeText(value.value);
		} catch {
			document.execCommand("copy");
		}
		copied.value = true;
	};
	return /* @__PURE__ */ a("div", {
		class: "note waits stack",
		"data-once": true,
		children: [
			/* @__PURE__ */ a("b", { children: label }),
			/* @__PURE__ */ a("span", { children: t("shown_once") }),
			/* @__PURE__ */ a("input", {
				ref: box,
				readOnly: true,
				class: "hex",
				"aria-label": label,
				value: value.value,
				onFocus: (event) => event.currentTarget.select()
			}),
			/* @__PURE__ */ a("div", {
				class: "acts-row",
				children: [/* @__PURE__ */ a("button", {
					type: "button",
					class: "primary",
					onClick: () => void copy(),
					children: t(copied.value ? "copied" : "copy")
				}), /* @__PURE__ */ a("button", {
					type: "button",
					onClick: () => {
						value.value = "";
						copied.value = false;
					},
					children: t("put_away")
				})]
			})
		]
	});
}
// src/parts/Staff.tsx
/** Users and keys: who may log in, which machines may call, with which roles; for administrators. */
function Staff() {
	const tab = useSignal("users");
	const why = refusal("GET /users");
	return /* @__PURE__ */ a("section", {
		class: "room",
		"aria-label": t("access"),
		children: [/* @__PURE__ */ a("div", {
			class: "head",
			children: [/* @__PURE__ */ a("h2", { children: t("access") }), /* @__PURE__ */ a("span", {
				class: "tabs",
				children: ["users", "keys"].map((name) => /* @__PURE__ */ a("button", {
					type: "button",
					"aria-pressed": tab.value === name,
					onClick: () => tab.value = name,
					children: t(name === "users" ? "users" : "machine_keys")
				}, name))
			})]
		}), why ? /* @__PURE__ */ a("p", {
			class: "nothing",
			children: why
		}) : tab.value === "users" ? /* @__PURE__ */ a(Users, {}) : /* @__PURE__ */ a(Keys, {})]
	});
}
function Roles({ value }) {
	const turn = (role, on) => {
		value.value = allRoles.value.filter((one) => one === role ? on : value.value.includes(one));
	};
	return /* @__PURE__ */ a("fieldset", {
		class: "roles",
		children: [/* @__PURE__ */ a("legend", { children: t("roles") }), allRoles.value.map((role) => /* @__PURE__ */ a("label", { children: [
			/* @__PURE__ */ a("input", {
				type: "checkbox",
				checked: value.value.includes(role),
				onChange: (event) => turn(role, event.currentTarget.checked)
			}),
			" ",
			said$1(`role_${role}`)
		] }, role))]
	});
}
function Users() {
	const again = useSignal(0);
	const chosen = useSignal(null);
	const { value } = useRead("/users", again.value);
	const user = value?.items.find(({ name }) => name === chosen.value);
	return /* @__PURE__ */ a("div", {
		class: "split",
		children: [/* @__PURE__ */ a(Table, {
			label: t("users"),
			rows: value?.items,
			keyOf: (row) => row.name,
			pick: (row) => chosen.value = row.name,
			chosen: chosen.value,
			none: t("no_users"),
			columns: [
				{
					name: t("name"),
					by: (row) => row.name,
					of: (row) => /* @__PURE__ */ a("button", {
						type: "button",
						class: "text",
						onClick: () => chosen.value = row.name,
						children: row.name
					})
				},
				{
					name: t("roles"),
					by: (row) => row.roles.join(),
					of: (row) => inWords$2(row.roles)
				},
				{
					name: t("state"),
					by: (row) => Number(row.disabled),
					of: (row) => /* @__PURE__ */ a("span", {
						class: row.disabled ? "bad" : "good",
						children: t(row.disabled ? "disabled" : "enabled")
					})
				},
				{
					name: t("logged_in"),
					by: (row) => row.logged_in,
					of: (row) => row.logged_in ? moment$1(row.logged_in) : t("never")
				},
				{
					name: t("added"),
					by: (row) => row.created,
					of: (row) => `${moment$1(row.created)} · ${row.created_by}`
				}
			]
		}), /* @__PURE__ */ a("div", { children: [user && /* @__PURE__ */ a(Change, {
			user,
			after: () => again.value++
		}, user.name), /* @__PURE__ */ a(Add, { after: () => again.value++ })] })]
	});
}
function Change({ user, after }) {
	const roles = useSignal(user.roles);
	const password = useSignal("");
	const asking = useAsking();
	const path = `/users/${encodeURIComponent(user.name)}`;
	const change = async (body, words) => {
		if (await asking.ask(() => call("PATCH", path, body), words)) {
			password.value = "";
			after();
		}
	};
	const same = roles.value.join() === user.roles.join();
	return /* @__PURE__ */ a("section", {
		class: "stack padded",
		"data-user": user.name,
		"aria-label": user.name,
		children: [
			/* @__PURE__ */ a("h2", {
				class: "sub",
				children: user.name
			}),
			/* @__PURE__ */ a(Roles, { value: roles }),
			/* @__PURE__ */ a("div", {
				class: "acts-row",
				children: [/* @__PURE__ */ a(Sure, {
					needs: "PATCH /users/{user}",
					label: t("change_roles"),
					disabled: same || roles.value.length === 0,
					does: () => void change({ roles: roles.value }, t("taken"))
				}), /* @__PURE__ */ a(Sure, {
					needs: "PATCH /users/{user}",
					label: t(user.disabled ? "enable" : "disable"),
					does: () => void change({ disabled: !user.disabled }, t("taken"))
				})]
			}),
			/* @__PURE__ */ a("div", {
				class: "fields",
				children: [/* @__PURE__ */ a(Field, {
					label: t("new_password"),
					name: "password",
					value: password,
					hint: t("password_rule")
				}), /* @__PURE__ */ a("div", {
					class: "acts-row",
					children: /* @__PURE__ */ a(Sure, {
						needs: "PATCH /users/{user}",
						label: t("reset_password"),
						disabled: !password.value,
						does: () => void change({ password: password.value }, t("password_reset", user.name))
					})
				})]
			}),
			/* @__PURE__ */ a(Told, { asking })
		]
	});
}
function Add({ after }) {
	const [name, password] = [useSignal(""), useSignal("")];
	const roles = useSignal([]);
	const asking = useAsking();
	const send = async (event) => {
		event.preventDefault();
		const body = {
			name: name.value.trim(),
			roles: roles.value,
			password: password.value
		};
		if (!await asking.ask(() => post("/users", body), t("user_added", body.name))) return;
		name.value = password.value = "";
		roles.value = [];
		after();
	};
	return /* @__PURE__ */ a("form", {
		class: "stack padded",
		"aria-label": t("add_user"),
		onSubmit: (event) => void send(event),
		children: [
			/* @__PURE__ */ a("h2", {
				class: "sub",
				children: t("add_user")
			}),
			/* @__PURE__ */ a("div", {
				class: "fields",
				children: [/* @__PURE__ */ a(Field, {
					label: t("name"),
					name: "name",
					value: name,
					required: true
				}), /* @__PURE__ */ a(Field, {
					label: t("password"),
					name: "password",
					value: password,
					hint: t("password_rule"),
					required: true
				})]
			}),
			/* @__PURE__ */ a(Roles, { value: roles }),
			/* @__PURE__ */ a("div", {
				class: "acts-row",
				children: /* @__PURE__ */ a(Button, {
					needs: "POST /users",
					type: "submit",
					disabled: roles.value.length === 0 || asking.busy.value,
					children: t("add_user")
				})
			}),
			/* @__PURE__ */ a(Told, { asking })
		]
	});
}
function Keys() {
	const again = useSignal(0);
	const { value } = useRead("/keys", again.value);
	const asking = useAsking();
	const revoke = async (name) => {
		await asking.ask(() => call("DELETE", `/keys/${encodeURIComponent(name)}`), t("key_revoked", name));
		again.value++;
	};
	return /* @__PURE__ */ a("div", {
		class: "split",
		children: [/* @__PURE__ */ a("div", { children: [/* @__PURE__ */ a(Told, { asking }), /* @__PURE__ */ a(Table, {
			label: t("machine_keys"),
			rows: value?.items,
			keyOf: (row) => row.name,
			none: t("no_keys"),
			columns: [
				{
					name: t("name"),
					by: (row) => row.name,
					of: (row) => row.name
				},
				{
					name: t("roles"),
					by: (row) => row.roles.join(),
					of: (row) => inWords$2(row.roles)
				},
				{
					name: t("state"),
					by: (row) => row.state,
					of: (row) => /* @__PURE__ */ a("span", {
						class: row.state === "active" ? "good" : "bad",
						children: said$1(row.state === "revoked" ? "key_revoked_state" : `key_${row.state}`)
					})
				},
				{
					name: t("expires"),
					by: (row) => row.expires,
					of: (row) => row.expires ? moment$1(row.expires) : t("never")
				},
				{
					name: t("last_used"),
					by: (row) => row.used,
					of: (row) => row.used ? moment$1(row.used) : t("never")
				},
				{
					name: t("added"),
					by: (row) => row.created,
					of: (row) => `${moment$1(row.created)} · ${row.created_by}`
				},
				{
					name: "",
					of: (row) => row.state === "active" && /* @__PURE__ */ a(Sure, {
						needs: "DELETE /keys/{key}",
						label: t("revoke"),
						does: () => void revoke(row.name)
					})
				}
			]
		})] }), /* @__PURE__ */ a(Issue, { after: () => again.value++ })]
	});
}
function Issue({ after }) {
	const [name, days] = [useSignal(""), useSignal("365")];
	const roles = useSignal([]);
	const made = useSignal("");
	const asking = useAsking();
	const send = async (event) => {
		event.preventDefault();
		const body = {
			name: name.value.trim(),
			roles: roles.value,
			...days.value ? { days: Number(days.value) } : {}
		};
		if (!await asking.ask(async () => {
			made.value = (await post("/keys", body)).key;
		}, "")) return;
		name.value = "";
		roles.value = [];
		after();
	};
	return /* @__PURE__ */ a("form", {
		class: "stack padded",
		"aria-label": t("issue_key"),
		onSubmit: (event) => void send(event),
		children: [
			/* @__PURE__ */ a("h2", {
				class: "sub",
				children: t("issue_key")
			}),
			/* @__PURE__ */ a("div", {
				class: "fields",
				children: [/* @__PURE__ */ a(Field, {
					label: t("name"),
					name: "name",
					value: name,
					required: true
				}), /* @__PURE__ */ a(Field, {
					label: t("days_good"),
					name: "days",
					type: "number",
					min: 1,
					max: 3660,
					value: days,
					hint: t("until_revoked")
				})]
			}),
			/* @__PURE__ */ a(Roles, { value: roles }),
			/* @__PURE__ */ a("div", {
				class: "acts-row",
				children: /* @__PURE__ */ a(Button, {
					needs: "POST /keys",
					type: "submit",
					disabled: roles.value.length === 0 || asking.busy.value,
					children: t("issue_key")
				})
			}),
			/* @__PURE__ */ a(Told, { asking }),
			/* @__PURE__ */ a(Once, {
				label: t("new_key"),
				value: made
			})
		]
	});
}
// src/parts/Stations.tsx
/** Stations and carriers: where everything is believed to be, and how well that is known. */
function Stations() {
	const tab = useSignal("stations");
	const letters = useSignal("");
	const group = useSignal("all");
	tick.value;
	const wanted = letters.value.trim().toLowerCase();
	const hits = (...names) => names.some((name) => name?.toLowerCase().includes(wanted));
	const groups = {
		all: () => true,
		present: (station) => station.present === true,
		free: (station) => station.present === false,
		unknown: (station) => station.present === null,
		believed: (station) => !station.verified,
		out_of_service: (station) => station.out_of_service !== "",
		reserved: (station) => station.reserved !== ""
	};
	const stations = stationList.value.filter((station) => hits(station.id, station.carrier, station.barcode) && groups[group.value]?.(station));
	const carriers = carrierList.value.filter((carrier) => hits(carrier.id, carrier.place));
	const since = (at) => at ? t("ago", span(serverNow() - Date.parse(at))) : "";
	return /* @__PURE__ */ a("section", {
		class: "room",
		"aria-label": t("stations"),
		children: [/* @__PURE__ */ a("div", {
			class: "head",
			children: [
				/* @__PURE__ */ a("h2", {
					class: "tabs-head",
					children: /* @__PURE__ */ a("span", {
						class: "tabs",
						children: [/* @__PURE__ */ a("button", {
							type: "button",
							"aria-pressed": tab.value === "stations",
							onClick: () => tab.value = "stations",
							children: [
								t("stations"),
								" ",
								counted(stationList.value.length)
							]
						}), /* @__PURE__ */ a("button", {
							type: "button",
							"aria-pressed": tab.value === "carriers",
							onClick: () => tab.value = "carriers",
							children: [
								t("carriers"),
								" ",
								counted(carrierList.value.length)
							]
						})]
					})
				}),
				tab.value === "stations" && /* @__PURE__ */ a("select", {
					"aria-label": t("state"),
					value: group.value,
					onChange: (event) => group.value = event.currentTarget.value,
					children: Object.keys(groups).map((name) => /* @__PURE__ */ a("option", {
						value: name,
						children: name === "free" ? t("empty") : said$1(name)
					}, name))
				}),
				/* @__PURE__ */ a("input", {
					type: "search",
					"aria-label": t("filter"),
					placeholder: t("filter"),
					value: letters.value,
					onInput: (event) => letters.value = event.currentTarget.value
				})
			]
		}), tab.value === "stations" ? /* @__PURE__ */ a(Table, {
			label: t("stations"),
			rows: stations,
			keyOf: ({ id }) => id,
			pick: ({ id }) => selected.value = {
				kind: "station",
				id
			},
			chosen: selected.value?.kind === "station" ? selected.value.id : null,
			none: t("nothing_found"),
			columns: [
				{
					name: t("at_station"),
					by: ({ id }) => id,
					of: ({ id }) => /* @__PURE__ */ a(Name, { id })
				},
				{
					name: t("kind"),
					by: ({ kind }) => kind,
					of: ({ kind }) => said$1(kind)
				},
				{
					name: t("barcode"),
					by: ({ barcode }) => barcode,
					of: ({ barcode }) => barcode
				},
				{
					name: t("present"),
					by: ({ present }) => present === null ? null : Number(present),
					of: ({ present }) => present === null ? t("unknown") : t(present ? "yes" : "no")
				},
				{
					name: t("carrier"),
					by: ({ carrier }) => carrier,
					of: ({ carrier }) => carrier ?? ""
				},
				{
					name: t("provenance"),
					by: ({ provenance }) => provenance,
					of: ({ provenance, verified }) => `${said$1(provenance)} · ${t(verified ? "verified" : "believed")}`
				},
				{
					name: t("age"),
					by: ({ at }) => at,
					of: ({ at }) => since(at)
				},
				{
					name: t("reserved"),
					by: ({ reserved }) => reserved || null,
					of: ({ reserved }) => reserved
				},
				{
					name: t("out_of_service"),
					by: (station) => station.out_of_service || null,
					of: (station) => station.out_of_service
				}
			]
		}) : /* @__PURE__ */ a("div", {
			class: "split",
			children: [/* @__PURE__ */ a(Table, {
				label: t("carriers"),
				rows: carriers,
				keyOf: ({ id }) => id,
				none: t("nothing_found"),
				columns: [
					{
						name: t("carrier"),
						by: ({ id }) => id,
						of: ({ id }) => id
					},
					{
						name: t("place"),
						by: ({ place }) => place,
						of: ({ place }) => place ? /* @__PURE__ */ a(Name, { id: place }) : t("unknown")
					},
					{
						name: t("provenance"),
						by: ({ provenance }) => provenance,
						of: ({ provenance, verified }) => `${said$1(provenance)} · ${t(verified ? "verified" : "believed")}`
					},
					{
						name: t("age"),
						by: ({ at }) => at,
						of: ({ at }) => since(at)
					},
					{
						name: "",
						of: ({ id }) => /* @__PURE__ */ a(Remove, { id })
					}
				]
			}), /* @__PURE__ */ a(Install, {})]
		})]
	});
}
function Remove({ id }) {
	const asking = useAsking();
	return /* @__PURE__ */ a($, { children: [/* @__PURE__ */ a(Sure, {
		needs: "DELETE /carriers/{carrier}",
		label: t("remove"),
		does: () => void asking.ask(() => call("DELETE", `/carriers/${encodeURIComponent(id)}`), "")
	}), /* @__PURE__ */ a(Told, { asking })] });
}
/** A person says where a carrier is. */
function Install() {
	const carrier = useSignal("");
	const place = useSignal("");
	const asking = useAsking();
	const send = (event) => {
		event.preventDefault();
		const path = `/carriers/${encodeURIComponent(carrier.value.trim())}`;
		asking.ask(() => call("PUT", path, {
			place: place.value.trim(),
			by_person: true
		}));
	};
	return /* @__PURE__ */ a("form", {
		class: "stack padded",
		onSubmit: send,
		children: [
			/* @__PURE__ */ a("h2", {
				class: "sub",
				children: t("carrier_is")
			}),
			/* @__PURE__ */ a("div", {
				class: "fields",
				children: [/* @__PURE__ */ a(Field, {
					label: t("carrier"),
					name: "carrier",
					value: carrier,
					required: true
				}), /* @__PURE__ */ a(Field, {
					label: t("place"),
					name: "place",
					value: place,
					required: true
				})]
			}),
			/* @__PURE__ */ a("div", {
				class: "acts-row",
				children: /* @__PURE__ */ a(Button, {
					needs: "PUT /carriers/{carrier}",
					type: "submit",
					children: t("write_down")
				})
			}),
			/* @__PURE__ */ a(Told, { asking })
		]
	});
}
// src/parts/Chart.tsx
/** A chart over time. */
var HEIGHT = 190;
/** How moments stand under a chart, from years down to seconds: the form, and what is added where the day changes. */
var MOMENTS = [
	[
		31536e3,
		"{YYYY}",
		null,
		null,
		null,
		null,
		null,
		null,
		1
	],
	[
		2419200,
		"{YYYY}-{MM}",
		null,
		null,
		null,
		null,
		null,
		null,
		1
	],
	[
		86400,
		"{MM}-{DD}",
		"\n{YYYY}",
		null,
		null,
		null,
		null,
		null,
		1
	],
	[
		60,
		"{HH}:{mm}",
		"\n{MM}-{DD}",
		null,
		"\n{MM}-{DD}",
		null,
		null,
		null,
		1
	],
	[
		1,
		"{HH}:{mm}:{ss}",
		"\n{MM}-{DD}",
		null,
		"\n{MM}-{DD}",
		null,
		null,
		null,
		1
	]
];
/** `times` in seconds since 1970, one for each value. Without any value there are words in place of empty axes. */
function Chart(shown) {
	if (shown.lines.some(({ values }) => values.some((value) => value !== null))) return /* @__PURE__ */ a(Drawn, { ...shown });
	return /* @__PURE__ */ a("figure", {
		class: "chart",
		children: [/* @__PURE__ */ a("figcaption", { children: shown.label }), /* @__PURE__ */ a("p", {
			class: "nothing",
			children: none(t("nothing_in_period"))
		})]
	});
}
function Drawn({ label, times, lines, unit }) {
	const box = T(null);
	const wears = theme.value;
	A$1(() => {
		const parent = box.current;
		const style = getComputedStyle(document.documentElement);
		const of = (name) => style.getPropertyValue(name).trim();
		const axis = {
			stroke: of("--dim"),
			grid: {
				stroke: of("--line"),
				width: 1
			},
			ticks: {
				stroke: of("--line"),
				width: 1
			}
		};
		const chart = new uPlot({
			width: parent.clientWidth,
			height: HEIGHT,
			series: [{
				label: t("when"),
				value: "{YYYY}-{MM}-{DD} {HH}:{mm}"
			}, ...lines.map((line) => ({
				label: line.label,
				stroke: of(line.colour),
				width: 2,
				...line.bars ? {
					fill: `${of(line.colour)}66`,
					paths: uPlot.paths.bars?.({ size: [.8, 40] })
				} : {}
			}))],
			axes: [{
				...axis,
				values: MOMENTS
			}, {
				...axis,
				label: unit,
				labelSize: 16,
				stroke: of("--dim")
			}],
			cursor: { drag: {
				x: true,
				y: false
			} }
		}, [times, ...lines.map(({ values }) => values)], parent);
		const size = new ResizeObserver(() => chart.setSize({
			width: parent.clientWidth,
			height: HEIGHT
		}));
		size.observe(parent);
		return () => {
			size.disconnect();
			chart.destroy();
		};
	}, [
		wears,
		language.value,
		times,
		lines
	]);
	return /* @__PURE__ */ a("figure", {
		class: "chart",
		children: [/* @__PURE__ */ a("figcaption", { children: label }), /* @__PURE__ */ a("div", {
			ref: box,
			role: "img",
			"aria-label": label
		})]
	});
}
// src/parts/Statistics.tsx
/** What a period came to: delivery times by phase, throughput, queue, vehicles, what was waited for; as files, and to print. */
var PERIODS = {
	hour: [3600, 60],
	shift: [28800, 900],
	day: [86400, 3600],
	week: [604800, 21600]
};
/** A period of one's own has so many intervals, none shorter than a minute. */
var INTERVALS = 60;
var KINDS = ["csv", "parquet"];
var PHASES = [
	"queued",
	"fetching",
	"acquiring",
	"carrying",
	"depositing",
	"total"
];
var TABLES = [
	"phases",
	"intervals",
	"vehicles",
	"waits",
	"places",
	"late",
	"open",
	"transfers"
];
/** Read anew so often, s. */
var EVERY$1 = 60;
function Statistics() {
	const period = useSignal("hour");
	const round = Math.floor(tick.value / EVERY$1);
	const kind = useSignal("csv");
	const own = {
		begin: useSignal(""),
		end: useSignal("")
	};
	const asked = period.value === "other" ? [own.begin.value, own.end.value] : [round];
	const query = w$2(() => queryOf(period.value, own.begin.value, own.end.value), [period.value, ...asked]);
	const { value, error } = useRead(query && `/statistics?${query}`);
	const asking = useAsking();
	const save = (path, name) => void asking.ask(() => download(path, name), "");
	return /* @__PURE__ */ a("section", {
		class: "room",
		"aria-label": t("statistics"),
		children: [/* @__PURE__ */ a("div", {
			class: "head",
			children: [
				/* @__PURE__ */ a("h2", { children: t("statistics") }),
				/* @__PURE__ */ a("span", {
					class: "tabs",
					children: [...Object.keys(PERIODS), "other"].map((name) => /* @__PURE__ */ a("button", {
						type: "button",
						"aria-pressed": period.value === name,
						onClick: () => period.value = name,
						children: t(`period_${name}`)
					}, name))
				}),
				period.value === "other" && /* @__PURE__ */ a("span", {
					class: "own",
					children: [/* @__PURE__ */ a(Field, {
						label: t("period_begin"),
						name: "begin",
						type: "datetime-local",
						value: own.begin
					}), /* @__PURE__ */ a(Field, {
						label: t("period_end"),
						name: "end",
						type: "datetime-local",
						value: own.end
					})]
				}),
				/* @__PURE__ */ a("select", {
					"aria-label": t("file_kind"),
					value: kind.value,
					onChange: (event) => kind.value = event.currentTarget.value,
					children: KINDS.map((name) => /* @__PURE__ */ a("option", {
						value: name,
						children: name === "csv" ? "CSV" : "Parquet"
					}, name))
				}),
				TABLES.map((table) => /* @__PURE__ */ a("button", {
					type: "button",
					disabled: query === null,
					onClick: () => save(`/statistics/${table}.${kind.value}?${query}`, `${table}.${kind.value}`),
					children: [t(`table_${table}`), " ⤓"]
				}, table)),
				/* @__PURE__ */ a("button", {
					type: "button",
					disabled: query === null,
					onClick: () => save(reportOf(query), "report.html"),
					children: [t("report"), " ⤓"]
				}),
				/* @__PURE__ */ a("button", {
					type: "button",
					disabled: query === null,
					title: t("print_report"),
					onClick: () => void asking.ask(() => print(reportOf(query)), ""),
					children: t("print")
				}),
				/* @__PURE__ */ a(Told, { asking }),
				/* @__PURE__ */ a(Problem, { error })
			]
		}), /* @__PURE__ */ a("div", {
			class: "scroll figures",
			tabIndex: 0,
			role: "group",
			"aria-label": t("statistics"),
			children: value && /* @__PURE__ */ a(Shown, { found: value })
		})]
	});
}
/** What is asked for; null: a period of one's own that is not whole yet. */
function queryOf(period, begin, end) {
	const of = (from, to, interval) => new URLSearchParams({
		from: new Date(from).toISOString(),
		to: new Date(to).toISOString(),
		interval: String(interval)
	});
	if (period !== "other") {
		const [length, interval] = PERIODS[period];
		const now = serverNow();
		return of(now - length * 1e3, now, interval);
	}
	const [from, to] = [Date.parse(begin), Date.parse(end)];
	if (!(from < to)) return null;
	return of(from, to, Math.max(60, Math.ceil((to - from) / 1e3 / INTERVALS)));
}
/** The report in the language of the page and the time of this browser. */
function reportOf(query) {
	const zone = Intl.DateTimeFormat().resolvedOptions().timeZone;
	return `/statistics/report?${query}&lang=${language.value}${zone ? `&tz=${encodeURIComponent(zone)}` : ""}`;
}
/** Open a page of the server by itself, and its print dialog. A link could not carry the access key. */
async function print(path) {
	const page = URL.createObjectURL(new Blob([await bytes(path)], { type: "text/html" }));
	const opened = window.open(page);
	opened?.addEventListener("load", () => opened.print());
}
var seconds = (value) => value === null ? "–" : value < 100 ? `${value.toFixed(1)} s` : span(value * 1e3);
function Shown({ found }) {
	const times = w$2(() => found.intervals.map((one) => Date.parse(one.begin) / 1e3), [found]);
	const through = w$2(() => [
		{
			label: t("completed"),
			colour: "--look-charging",
			values: found.intervals.map((one) => one.completed),
			bars: true
		},
		{
			label: t("jobs_ordered"),
			colour: "--look-moving",
			values: found.intervals.map((one) => one.ordered)
		},
		{
			label: t("queue"),
			colour: "--look-waiting",
			values: found.intervals.map((one) => one.queue)
		}
	], [found, language.value]);
	const delivery = w$2(() => [{
		label: "p50",
		colour: "--look-moving",
		values: found.intervals.map((one) => one.delivery.p50)
	}, {
		label: "p95",
		colour: "--look-held",
		values: found.intervals.map((one) => one.delivery.p95)
	}], [found]);
	const most = Math.max(1, ...found.waits.map((one) => one.seconds));
	return /* @__PURE__ */ a($, { children: [
		/* @__PURE__ */ a("p", {
			class: "tiles",
			children: [Object.entries(found.jobs).map(([state, count]) => /* @__PURE__ */ a("span", { children: [
				/* @__PURE__ */ a("b", { children: count }),
				" ",
				said$1(state)
			] }, state)), /* @__PURE__ */ a("span", { children: [
				/* @__PURE__ */ a("b", { children: found.empty_share === null ? "–" : `${Math.round(found.empty_share * 100)} %` }),
				" ",
				t("empty_travel")
			] })]
		}),
		/* @__PURE__ */ a(Chart, {
			label: t("throughput"),
			times,
			lines: through,
			unit: t("jobs")
		}),
		/* @__PURE__ */ a(Chart, {
			label: t("delivery_time"),
			times,
			lines: delivery,
			unit: t("seconds_unit")
		}),
		/* @__PURE__ */ a(Phases, { phases: found.phases }),
		/* @__PURE__ */ a("h3", { children: t("waits_by_cause") }),
		/* @__PURE__ */ a("table", {
			class: "list",
			children: /* @__PURE__ */ a("tbody", { children: found.waits.map((one) => /* @__PURE__ */ a("tr", { children: [
				/* @__PURE__ */ a("td", { children: tell(said$1(one.cause)) }),
				/* @__PURE__ */ a("td", {
					class: "number",
					children: one.times
				}),
				/* @__PURE__ */ a("td", {
					class: "number",
					children: span(one.seconds * 1e3)
				}),
				/* @__PURE__ */ a("td", {
					class: "bar",
					children: /* @__PURE__ */ a("i", { style: { width: `${100 * one.seconds / most}%` } })
				})
			] }, one.cause)) })
		}),
		found.waits.length === 0 && /* @__PURE__ */ a("p", {
			class: "nothing",
			children: t("never_waited")
		}),
		/* @__PURE__ */ a(Lateness, { found }),
		/* @__PURE__ */ a("h3", { children: t("vehicles") }),
		/* @__PURE__ */ a(Table, {
			label: t("vehicles"),
			rows: found.vehicles,
			keyOf: (row) => row.vehicle,
			none: t("nothing_found"),
			columns: [
				{
					name: t("vehicle"),
					by: (row) => row.vehicle,
					of: (row) => /* @__PURE__ */ a(Name, { id: row.vehicle })
				},
				{
					name: t("completed"),
					by: (row) => row.completed,
					of: (row) => row.completed,
					number: true
				},
				{
					name: t("utilisation"),
					by: (row) => row.busy_share,
					of: (row) => `${(row.busy_share * 100).toFixed(1)} %`,
					number: true
				},
				{
					name: t("failures"),
					by: (row) => row.failures,
					of: (row) => row.failures,
					number: true
				},
				{
					name: t("mtbf_hours"),
					by: (row) => row.mtbf_hours,
					of: (row) => row.mtbf_hours ?? "–",
					number: true
				},
				{
					name: t("mttr_minutes"),
					by: (row) => row.mttr_minutes,
					of: (row) => row.mttr_minutes ?? "–",
					number: true
				},
				{
					name: t("availability"),
					by: (row) => row.availability,
					of: (row) => `${(row.availability * 100).toFixed(2)} %`,
					number: true
				}
			]
		})
	] });
}
/** Why lots were late: where jobs waited, the latest by name, and what is still open. */
function Lateness({ found }) {
	const reason = (row) => tell(said$1(row.reason));
	const pick = (row) => void (selected.value = {
		kind: "job",
		id: row.job
	});
	return /* @__PURE__ */ a($, { children: [
		/* @__PURE__ */ a("h3", { children: t("waits_by_place") }),
		/* @__PURE__ */ a(Table, {
			label: t("waits_by_place"),
			rows: found.places,
			keyOf: (row) => row.place,
			none: t("nothing_found"),
			columns: [
				{
					name: t("place"),
					by: (row) => row.place,
					of: (row) => /* @__PURE__ */ a(Name, { id: row.place })
				},
				{
					name: t("jobs"),
					by: (row) => row.jobs,
					of: (row) => row.jobs,
					number: true
				},
				{
					name: t("waits"),
					by: (row) => row.seconds,
					of: (row) => seconds(row.seconds),
					number: true
				},
				{
					name: t("cause"),
					by: (row) => row.cause,
					of: (row) => tell(said$1(row.cause)),
					wraps: true
				}
			]
		}),
		/* @__PURE__ */ a("h3", { children: t("late_lots") }),
		/* @__PURE__ */ a(Table, {
			label: t("late_lots"),
			rows: found.late,
			keyOf: (row) => row.job,
			pick,
			none: t("nothing_found"),
			columns: [
				{
					name: t("job"),
					by: (row) => row.job,
					of: (row) => row.job
				},
				{
					name: t("source"),
					by: (row) => row.source,
					of: (row) => row.source
				},
				{
					name: t("destination"),
					by: (row) => row.destination,
					of: (row) => row.destination
				},
				...PHASES.map((phase) => ({
					name: t(`phase_${phase}`),
					by: (row) => row[phase],
					of: (row) => seconds(row[phase]),
					number: true
				})),
				{
					name: t("longest_wait"),
					by: (row) => row.waited,
					of: (row) => seconds(row.waited),
					number: true
				},
				{
					name: t("waited_for"),
					by: reason,
					of: reason,
					wraps: true
				}
			]
		}),
		/* @__PURE__ */ a("h3", { children: t("open_at_end") }),
		/* @__PURE__ */ a(Table, {
			label: t("open_at_end"),
			rows: found.open,
			keyOf: (row) => row.job,
			pick,
			none: t("nothing_found"),
			columns: [
				{
					name: t("job"),
					by: (row) => row.job,
					of: (row) => row.job
				},
				{
					name: t("source"),
					by: (row) => row.source,
					of: (row) => row.source
				},
				{
					name: t("destination"),
					by: (row) => row.destination,
					of: (row) => row.destination
				},
				{
					name: t("age"),
					by: (row) => row.seconds,
					of: (row) => seconds(row.seconds),
					number: true
				},
				{
					name: t("waited_for"),
					by: reason,
					of: reason,
					wraps: true
				}
			]
		})
	] });
}
function Phases({ phases }) {
	return /* @__PURE__ */ a($, { children: [/* @__PURE__ */ a("h3", { children: t("phases") }), /* @__PURE__ */ a("table", {
		class: "list",
		children: [/* @__PURE__ */ a("thead", { children: /* @__PURE__ */ a("tr", { children: [
			t("phase"),
			t("count"),
			t("mean"),
			"p50",
			"p95",
			t("longest")
		].map((name) => /* @__PURE__ */ a("th", { children: /* @__PURE__ */ a("span", { children: name }) }, name)) }) }), /* @__PURE__ */ a("tbody", { children: PHASES.filter((name) => phases[name]).map((name) => {
			const { count, mean, p50, p95, longest } = phases[name];
			return /* @__PURE__ */ a("tr", {
				"data-phase": name,
				children: [
					/* @__PURE__ */ a("td", { children: t(`phase_${name}`) }),
					/* @__PURE__ */ a("td", { children: count }),
					[
						mean,
						p50,
						p95,
						longest
					].map((value, i) => /* @__PURE__ */ a("td", { children: seconds(value) }, i))
				]
			}, name);
		}) })]
	})] });
}
// src/parts/TeachingFiles.tsx
/** Taught values as files: saved, and read back after a look at what each row would come to. */
var TONES$1 = {
	new: "good",
	changed: "wait",
	same: "calm",
	error: "bad"
};
function TeachingFiles() {
	const side = useSignal("dests");
	const file = useSignal(null);
	const report = useSignal(null);
	const asking = useAsking();
	const ask = (dry) => void asking.ask(async () => {
		const given = file.value;
		report.value = null;
		report.value = await upload(`/teaching/${side.value}/import?dry_run=${dry}`, await given.text(), given.name.endsWith(".json") ? "application/json" : "text/csv");
		if (!dry) file.value = null;
	}, dry ? "" : t("imported"));
	const choose = (chosen) => {
		file.value = chosen ?? null;
		if (chosen) ask(true);
	};
	const save = (kind, history) => void asking.ask(() => download(`/teaching/${side.value}?format=${kind}&history=${history}`, `${side.value}.${kind}`), "");
	const found = report.value;
	const wrong = found?.counts["error"] ?? 0;
	return /* @__PURE__ */ a("div", {
		class: "filtered",
		children: [
			/* @__PURE__ */ a("div", {
				class: "stack padded",
				children: [
					/* @__PURE__ */ a("div", {
						class: "fields",
						children: [/* @__PURE__ */ a(Choice$1, {
							label: t("kind"),
							value: side,
							of: [["dests", t("dests_of_ports")], ["offsets", t("offsets_of_vehicles")]]
						}), /* @__PURE__ */ a("div", {
							class: "acts-row",
							children: [
								/* @__PURE__ */ a("button", {
									type: "button",
									onClick: () => save("csv", false),
									children: t("save_csv")
								}),
								/* @__PURE__ */ a("button", {
									type: "button",
									onClick: () => save("json", false),
									children: t("save_json")
								}),
								/* @__PURE__ */ a("button", {
									type: "button",
									onClick: () => save("csv", true),
									children: t("save_history")
								}),
								/* @__PURE__ */ a("label", {
									class: "file",
									children: [/* @__PURE__ */ a("span", { children: t("read_file") }), /* @__PURE__ */ a("input", {
										type: "file",
										accept: ".csv,.json,text/csv,application/json",
										"aria-label": t("read_file"),
										onChange: (event) => {
											choose(event.currentTarget.files?.[0]);
											event.currentTarget.value = "";
										}
									})]
								})
							]
						})]
					}),
					found && /* @__PURE__ */ a("p", {
						role: "status",
						"data-import": found.dry_run ? "tried" : "done",
						children: [
							"new",
							"changed",
							"same",
							"error"
						].map((fate) => /* @__PURE__ */ a("span", {
							class: TONES$1[fate] ?? "",
							children: [
								/* @__PURE__ */ a("b", { children: found.counts[fate] }),
								" ",
								t(`fate_${fate}`),
								" "
							]
						}, fate))
					}),
					found?.dry_run && file.value && /* @__PURE__ */ a("div", {
						class: "acts-row",
						children: [/* @__PURE__ */ a("span", { children: wrong ? t("import_wrong") : t("import_ready", file.value.name) }), /* @__PURE__ */ a(Sure, {
							needs: side.value === "dests" ? "POST /teaching/dests/import" : "POST /teaching/offsets/import",
							label: t("import"),
							disabled: wrong > 0,
							does: () => ask(false)
						})]
					}),
					/* @__PURE__ */ a(Told, { asking })
				]
			}),
			!found && /* @__PURE__ */ a(InForce, { side: side.value }),
			found && /* @__PURE__ */ a(Table, {
				label: t("import"),
				rows: found.items,
				keyOf: (row) => String(row.line),
				none: t("import_none"),
				columns: [
					{
						name: t("line_of_file"),
						by: (row) => row.line,
						of: (row) => row.line,
						number: true
					},
					{
						name: t("name"),
						by: (row) => row.name,
						of: (row) => /* @__PURE__ */ a(Name, { id: row.name })
					},
					{
						name: t("result"),
						by: (row) => row.fate,
						of: (row) => /* @__PURE__ */ a("b", {
							class: TONES$1[row.fate] ?? "",
							children: t(`fate_${row.fate}`)
						})
					},
					{
						name: t("in_words"),
						wraps: true,
						of: (row) => [tell(row.detail), tell(row.remedy)].filter(Boolean).join("; ")
					}
				]
			})
		]
	});
}
/** What the file would have: the values that pick-ups and put-downs are reckoned from now. */
function InForce({ side }) {
	const { value } = useRead(`/teaching/${side}`, changes.teaching.value);
	const nameOf = (row) => row.station ?? row.vehicle ?? "";
	return /* @__PURE__ */ a(Table, {
		label: t("in_force"),
		rows: value?.items,
		keyOf: nameOf,
		none: t("never_taught"),
		columns: [
			{
				name: t("name"),
				by: nameOf,
				of: (row) => /* @__PURE__ */ a(Name, { id: nameOf(row) })
			},
			...[
				"shft",
				"rota",
				"lift"
			].map((axis) => ({
				name: axis.toUpperCase(),
				by: (row) => row[axis],
				of: (row) => row[axis] ?? "–",
				number: true
			})),
			{
				name: t("version"),
				by: (row) => row.version,
				of: (row) => `v${row.version}`,
				number: true
			},
			{
				name: t("when"),
				by: (row) => row.at,
				of: (row) => moment$1(row.at)
			},
			{
				name: t("who"),
				by: (row) => row.actor,
				of: (row) => `${row.actor} · ${tell(row.source)}`
			}
		]
	});
}
// src/parts/TeachingRaw.tsx
/** What vehicles sent while they were taught, as they sent it; and the offsets of two vehicles side by side. */
function TeachingRaw() {
	const after = useSignal(0);
	const { value } = useRead(`/teaching/events?limit=200&after=${after.value}`, changes.teaching.value);
	return /* @__PURE__ */ a("div", {
		class: "filtered",
		children: [
			/* @__PURE__ */ a(TwoOffsets, {}),
			/* @__PURE__ */ a(Table, {
				label: t("teaching_events"),
				rows: [...value?.items ?? []].reverse(),
				keyOf: (row) => String(row.number),
				none: t("no_proposals"),
				columns: [
					{
						name: "#",
						by: (row) => row.number,
						of: (row) => row.number,
						number: true
					},
					{
						name: t("when"),
						by: (row) => row.at,
						of: (row) => moment$1(row.at)
					},
					{
						name: t("vehicle"),
						by: (row) => row.vehicle,
						of: (row) => /* @__PURE__ */ a(Name, { id: row.vehicle })
					},
					{
						name: t("barcode"),
						by: (row) => row.barcode,
						of: (row) => row.barcode
					},
					{
						name: t("what"),
						by: (row) => row.code,
						of: (row) => `${row.axis?.toUpperCase() ?? "–"} · 0x${row.code}`
					},
					{
						name: t("position"),
						by: (row) => row.position,
						of: (row) => row.position ?? "–",
						number: true
					},
					{
						name: t("asked_by"),
						by: (row) => row.asked_by,
						of: (row) => row.asked_by ?? ""
					}
				]
			}),
			/* @__PURE__ */ a("div", {
				class: "padded acts-row",
				children: [/* @__PURE__ */ a("button", {
					type: "button",
					disabled: after.value === 0,
					onClick: () => after.value = 0,
					children: t("from_start")
				}), /* @__PURE__ */ a("button", {
					type: "button",
					disabled: !value?.next,
					onClick: () => after.value = value?.next ?? 0,
					children: [t("newer_rows"), " ▶"]
				})]
			})
		]
	});
}
function TwoOffsets() {
	const [one, other] = [useSignal(""), useSignal("")];
	const hoists = layout.value?.vehicles.filter(({ kind }) => kind !== "agv") ?? [];
	const known = (id) => hoists.some((vehicle) => vehicle.id === id);
	const ready = known(one.value) && known(other.value) && one.value !== other.value;
	const path = `/teaching/compare/offsets/${encodeURIComponent(one.value)}/${encodeURIComponent(other.value)}`;
	const { value, error } = useRead(ready ? path : null, changes.teaching.value);
	return /* @__PURE__ */ a("div", {
		class: "stack padded",
		role: "group",
		"aria-label": t("compare_offsets"),
		children: [
			/* @__PURE__ */ a("h2", {
				class: "sub",
				children: t("compare_offsets")
			}),
			/* @__PURE__ */ a("div", {
				class: "fields",
				children: [/* @__PURE__ */ a(Field, {
					label: t("vehicle"),
					name: "one",
					value: one,
					list: "offset-hoists"
				}), /* @__PURE__ */ a(Field, {
					label: t("vehicle_other"),
					name: "other",
					value: other,
					list: "offset-hoists"
				})]
			}),
			/* @__PURE__ */ a("datalist", {
				id: "offset-hoists",
				children: hoists.map(({ id }) => /* @__PURE__ */ a("option", { value: id }, id))
			}),
			ready && /* @__PURE__ */ a(Problem, { error }),
			ready && value && /* @__PURE__ */ a("dl", {
				class: "facts",
				children: [
					/* @__PURE__ */ a(Fact, {
						name: one.value,
						children: /* @__PURE__ */ a(Pulses, { axes: value.one })
					}),
					/* @__PURE__ */ a(Fact, {
						name: other.value,
						children: /* @__PURE__ */ a(Pulses, { axes: value.other })
					}),
					/* @__PURE__ */ a(Fact, {
						name: t("difference"),
						children: /* @__PURE__ */ a(Pulses, {
							axes: value.differences,
							signed: true
						})
					})
				]
			})
		]
	});
}
// src/parts/Teaching.tsx
/** Teaching: sessions, what they propose and what that would change, drift, and what a vehicle would be sent at a port. */
var TABS = [
	"proposals",
	"sessions",
	"drift",
	"dry_run",
	"files",
	"raw"
];
function Teaching() {
	const tab = useSignal("proposals");
	return /* @__PURE__ */ a("section", {
		class: "room",
		"aria-label": t("teaching"),
		children: [
			/* @__PURE__ */ a("div", {
				class: "head",
				children: [/* @__PURE__ */ a("h2", { children: t("teaching") }), /* @__PURE__ */ a("span", {
					class: "tabs",
					children: TABS.map((name) => /* @__PURE__ */ a("button", {
						type: "button",
						"aria-pressed": tab.value === name,
						onClick: () => tab.value = name,
						children: t(name === "files" || name === "raw" ? `teaching_${name}` : name)
					}, name))
				})]
			}),
			tab.value === "proposals" && /* @__PURE__ */ a(Proposals, {}),
			tab.value === "sessions" && /* @__PURE__ */ a(Sessions, {}),
			tab.value === "drift" && /* @__PURE__ */ a(Drift, {}),
			tab.value === "dry_run" && /* @__PURE__ */ a(DryRun, {}),
			tab.value === "files" && /* @__PURE__ */ a(TeachingFiles, {}),
			tab.value === "raw" && /* @__PURE__ */ a(TeachingRaw, {})
		]
	});
}
var OPEN = /* @__PURE__ */ new Set([
	"collecting",
	"ready",
	"incomplete",
	"out_of_range",
	"wrong_mode",
	"pending",
	"ambiguous"
]);
var tone$1 = (state) => state === "approved" ? "good" : state === "rejected" ? "calm" : OPEN.has(state) ? "wait" : "";
function Proposals() {
	const chosen = useSignal(null);
	const { value } = useRead("/teaching/proposals?limit=200", changes.teaching.value);
	const id = chosen.value ?? value?.items[0]?.id ?? null;
	return /* @__PURE__ */ a("div", {
		class: "split",
		children: [/* @__PURE__ */ a(Table, {
			label: t("proposals"),
			rows: value?.items,
			keyOf: (row) => String(row.id),
			pick: (row) => chosen.value = row.id,
			chosen: String(id),
			none: t("no_proposals"),
			columns: [
				{
					name: "#",
					by: (row) => row.id,
					of: (row) => row.id,
					number: true
				},
				{
					name: t("state"),
					by: (row) => row.state,
					of: (row) => /* @__PURE__ */ a("span", {
						class: `state ${tone$1(row.state)}`,
						children: said$1(row.state)
					})
				},
				{
					name: t("kind"),
					by: (row) => row.side,
					of: (row) => t(row.side)
				},
				{
					name: t("at_station"),
					by: (row) => row.station,
					of: (row) => /* @__PURE__ */ a(Name, { id: row.station })
				},
				{
					name: t("vehicle"),
					by: (row) => row.vehicle,
					of: (row) => /* @__PURE__ */ a(Name, { id: row.vehicle })
				},
				{
					name: t("new"),
					of: (row) => /* @__PURE__ */ a(Pulses, { axes: row.result })
				},
				{
					name: t("when"),
					by: (row) => row.at,
					of: (row) => clock(row.at)
				}
			]
		}), id === null ? /* @__PURE__ */ a("p", {
			class: "nothing",
			children: none(t("choose_proposal"))
		}) : /* @__PURE__ */ a(Detail$1, { id }, id)]
	});
}
/** A proposal: what was sent, what it would make, for whom that changes anything; and the decision. */
function Detail$1({ id }) {
	const again = useSignal(0);
	const { value: proposal } = useRead(`/teaching/proposals/${id}`, changes.teaching.value, again.value);
	const station = useSignal("");
	const asking = useAsking();
	if (!proposal) return /* @__PURE__ */ a("div", {});
	const path = `/teaching/proposals/${id}`;
	const match = { "If-Match": `"${proposal.revision}"` };
	const over = proposal.closed !== null;
	const against = [
		"incomplete",
		"wrong_mode",
		"out_of_range"
	].includes(proposal.state) ? [proposal.state] : [];
	const decide = (verb, body) => async (reason) => {
		await post(`${path}/${verb}`, {
			...body,
			reason
		}, match);
		again.value++;
	};
	return /* @__PURE__ */ a("div", {
		class: "stack padded",
		"data-proposal": id,
		children: [
			/* @__PURE__ */ a("h2", {
				class: "sub",
				children: [
					t(proposal.side),
					" · ",
					proposal.station ?? "?",
					" · ",
					proposal.vehicle
				]
			}),
			proposal.why && /* @__PURE__ */ a("p", {
				class: "note waits",
				children: [
					tell(proposal.why),
					" ",
					/* @__PURE__ */ a("em", { children: tell(proposal.remedy) })
				]
			}),
			[...proposal.warnings, proposal.drift].filter(Boolean).map((words) => /* @__PURE__ */ a("p", {
				class: "note held",
				children: tell(words)
			}, words)),
			/* @__PURE__ */ a("dl", {
				class: "facts",
				children: [
					/* @__PURE__ */ a(Fact, {
						name: t("sent_positions"),
						children: /* @__PURE__ */ a(Pulses, { axes: proposal.raw })
					}),
					/* @__PURE__ */ a(Fact, {
						name: t("old"),
						children: [
							/* @__PURE__ */ a(Pulses, { axes: proposal.present }),
							" ",
							proposal.present && /* @__PURE__ */ a("small", { children: ["v", proposal.present.version] })
						]
					}),
					/* @__PURE__ */ a(Fact, {
						name: t("new"),
						children: /* @__PURE__ */ a(Pulses, {
							axes: proposal.result,
							before: proposal.present
						})
					}),
					proposal.asked_by && /* @__PURE__ */ a(Fact, {
						name: t("asked_by"),
						children: proposal.asked_by
					}),
					over && /* @__PURE__ */ a(Fact, {
						name: said$1(proposal.state),
						children: [
							proposal.closed_by,
							" · ",
							clock(proposal.closed ?? ""),
							" ",
							proposal.reason
						]
					})
				]
			}),
			/* @__PURE__ */ a(Changes, { changes: proposal.changes }),
			!over && proposal.state === "ambiguous" && /* @__PURE__ */ a("div", {
				class: "fields",
				children: [
					/* @__PURE__ */ a(Field, {
						label: t("at_station"),
						value: station,
						list: "station-names"
					}),
					/* @__PURE__ */ a("div", {
						class: "acts-row",
						children: /* @__PURE__ */ a(Button, {
							needs: "POST /teaching/proposals/{proposal}/assign",
							disabled: !station.value,
							onClick: () => void asking.ask(() => post(`${path}/assign`, { station: station.value.trim() }, match)),
							children: t("assign")
						})
					}),
					/* @__PURE__ */ a("datalist", {
						id: "station-names",
						children: layout.value?.stations.map((one) => /* @__PURE__ */ a("option", { value: one.id }, one.id))
					})
				]
			}),
			!over && /* @__PURE__ */ a(Reasoned, {
				asking,
				decisions: [{
					label: t(against.length ? "approve_anyway" : "approve"),
					needs: "POST /teaching/proposals/{proposal}/approve",
					bare: against.length === 0,
					grave: true,
					does: decide("approve", { accept: against })
				}, {
					label: t("reject"),
					needs: "POST /teaching/proposals/{proposal}/reject",
					does: decide("reject", {})
				}]
			})
		]
	});
}
function Sessions() {
	const chosen = useSignal(null);
	const station = useSignal("");
	const vehicle = useSignal("");
	const asking = useAsking();
	const { value } = useRead("/teaching/sessions?limit=100", changes.teaching.value);
	const open = (event) => {
		event.preventDefault();
		asking.ask(async () => {
			const made = await post("/teaching/sessions", {
				station: station.value.trim(),
				vehicle: vehicle.value.trim()
			});
			chosen.value = made.id;
		});
	};
	const ports = layout.value?.stations.filter(({ kind }) => kind === "port") ?? [];
	const hoists = layout.value?.vehicles.filter(({ kind }) => kind !== "agv") ?? [];
	return /* @__PURE__ */ a("div", {
		class: "split",
		children: [/* @__PURE__ */ a(Table, {
			label: t("sessions"),
			rows: value?.items,
			keyOf: (row) => String(row.id),
			pick: (row) => chosen.value = row.id,
			chosen: String(chosen.value),
			none: t("no_sessions"),
			columns: [
				{
					name: "#",
					by: (row) => row.id,
					of: (row) => row.id,
					number: true
				},
				{
					name: t("state"),
					by: (row) => row.state,
					of: (row) => said$1(row.state)
				},
				{
					name: t("at_station"),
					by: (row) => row.station,
					of: (row) => /* @__PURE__ */ a(Name, { id: row.station })
				},
				{
					name: t("vehicle"),
					by: (row) => row.vehicle,
					of: (row) => /* @__PURE__ */ a(Name, { id: row.vehicle })
				},
				{
					name: t("who"),
					by: (row) => row.actor,
					of: (row) => row.actor
				},
				{
					name: t("when"),
					by: (row) => row.opened,
					of: (row) => clock(row.opened)
				}
			]
		}), /* @__PURE__ */ a("div", { children: [/* @__PURE__ */ a("form", {
			class: "stack padded",
			onSubmit: open,
			children: [
				/* @__PURE__ */ a("h2", {
					class: "sub",
					children: t("teach_port")
				}),
				/* @__PURE__ */ a("div", {
					class: "fields",
					children: [/* @__PURE__ */ a(Field, {
						label: t("port"),
						name: "station",
						value: station,
						list: "port-names",
						required: true
					}), /* @__PURE__ */ a(Field, {
						label: t("vehicle"),
						name: "vehicle",
						value: vehicle,
						list: "hoist-names",
						required: true
					})]
				}),
				/* @__PURE__ */ a("datalist", {
					id: "port-names",
					children: ports.map(({ id }) => /* @__PURE__ */ a("option", { value: id }, id))
				}),
				/* @__PURE__ */ a("datalist", {
					id: "hoist-names",
					children: hoists.map(({ id }) => /* @__PURE__ */ a("option", { value: id }, id))
				}),
				/* @__PURE__ */ a("div", {
					class: "acts-row",
					children: /* @__PURE__ */ a(Button, {
						needs: "POST /teaching/sessions",
						type: "submit",
						children: t("open_session")
					})
				}),
				/* @__PURE__ */ a(Told, { asking })
			]
		}), chosen.value !== null && /* @__PURE__ */ a(Session, { id: chosen.value }, chosen.value)] })]
	});
}
function Session({ id }) {
	const { value: session } = useRead(`/teaching/sessions/${id}`, changes.teaching.value, Math.floor(changes.vehicles.value / 20));
	const asking = useAsking();
	if (!session) return null;
	const path = `/teaching/sessions/${id}`;
	return /* @__PURE__ */ a("div", {
		class: "stack padded",
		"data-session": id,
		children: [
			/* @__PURE__ */ a("h2", {
				class: "sub",
				children: [
					"#",
					id,
					" ",
					session.station,
					" · ",
					session.vehicle,
					" · ",
					said$1(session.state)
				]
			}),
			/* @__PURE__ */ a("p", {
				class: "note waits",
				children: tell(session.advice)
			}),
			session.state === "open" && /* @__PURE__ */ a($, { children: [/* @__PURE__ */ a("div", {
				class: "acts-row",
				children: ["dest", "offset"].map((what) => /* @__PURE__ */ a(Button, {
					needs: "POST /teaching/sessions/{session}/start",
					onClick: () => void asking.ask(() => post(`${path}/start`, { what }), t("sent")),
					children: t(what === "dest" ? "teach_dest" : "teach_offset")
				}, what))
			}), /* @__PURE__ */ a(Reasoned, {
				asking,
				decisions: [{
					label: t("close_session"),
					needs: "POST /teaching/sessions/{session}/close",
					bare: true,
					does: (reason) => post(`${path}/close`, { reason })
				}, {
					label: t("abandon"),
					needs: "POST /teaching/sessions/{session}/close",
					bare: true,
					grave: true,
					does: (reason) => post(`${path}/close`, {
						reason,
						abandon: true
					})
				}]
			})] }),
			session.proposals.map((proposal) => /* @__PURE__ */ a("p", { children: [
				"#",
				proposal.id,
				" ",
				said$1(proposal.state),
				" ",
				/* @__PURE__ */ a(Pulses, { axes: proposal.result })
			] }, proposal.id))
		]
	});
}
function Drift() {
	const { value } = useRead("/teaching/drift", changes.teaching.value);
	return /* @__PURE__ */ a(Table, {
		label: t("drift"),
		rows: value?.items,
		keyOf: (row) => row.side + row.name,
		none: t("no_drift"),
		columns: [
			{
				name: t("kind"),
				by: (row) => row.side,
				of: (row) => t(row.side)
			},
			{
				name: t("name"),
				by: (row) => row.name,
				of: (row) => /* @__PURE__ */ a(Name, { id: row.name })
			},
			{
				name: t("old"),
				of: (row) => /* @__PURE__ */ a(Pulses, { axes: row.old })
			},
			{
				name: t("new"),
				of: (row) => /* @__PURE__ */ a(Pulses, {
					axes: row.new,
					before: row.old
				})
			},
			{
				name: t("drift"),
				of: (row) => tell(row.drift)
			}
		]
	});
}
/** What a vehicle would be sent at a port, and from which rows; nothing is sent. */
function DryRun() {
	const station = useSignal("");
	const vehicle = useSignal("");
	const ready = layout.value?.stations.some(({ id }) => id === station.value) && layout.value.vehicles.some(({ id }) => id === vehicle.value);
	const path = `/teaching/targets/${encodeURIComponent(station.value)}/${encodeURIComponent(vehicle.value)}`;
	const { value } = useRead(ready ? path : null, changes.teaching.value);
	return /* @__PURE__ */ a("div", {
		class: "stack padded",
		children: [
			/* @__PURE__ */ a("div", {
				class: "fields",
				children: [/* @__PURE__ */ a(Field, {
					label: t("port"),
					name: "station",
					value: station,
					list: "dry-ports"
				}), /* @__PURE__ */ a(Field, {
					label: t("vehicle"),
					name: "vehicle",
					value: vehicle,
					list: "dry-hoists"
				})]
			}),
			/* @__PURE__ */ a("datalist", {
				id: "dry-ports",
				children: layout.value?.stations.filter(({ kind }) => kind === "port").map(({ id }) => /* @__PURE__ */ a("option", { value: id }, id))
			}),
			/* @__PURE__ */ a("datalist", {
				id: "dry-hoists",
				children: layout.value?.vehicles.filter(({ kind }) => kind !== "agv").map(({ id }) => /* @__PURE__ */ a("option", { value: id }, id))
			}),
			ready && value && /* @__PURE__ */ a("dl", {
				class: "facts",
				children: [
					/* @__PURE__ */ a(Fact, {
						name: t("target"),
						children: /* @__PURE__ */ a(Pulses, { axes: value })
					}),
					/* @__PURE__ */ a(Fact, {
						name: t("dest"),
						children: [
							/* @__PURE__ */ a(Pulses, { axes: value.dest }),
							" ",
							value.dest && /* @__PURE__ */ a("small", { children: ["v", value.dest.version] })
						]
					}),
					/* @__PURE__ */ a(Fact, {
						name: t("offset"),
						children: [
							value.reference ? t("reference_vehicle") : /* @__PURE__ */ a(Pulses, { axes: value.offset }),
							" ",
							value.offset && /* @__PURE__ */ a("small", { children: ["v", value.offset.version] })
						]
					}),
					value.refusal && /* @__PURE__ */ a(Fact, {
						name: t("refused"),
						children: /* @__PURE__ */ a("span", {
							class: "bad",
							children: tell(value.refusal)
						})
					})
				]
			})
		]
	});
}
// src/parts/Transfer.tsx
/** The form that orders a transfer. */
var key = freshKey();
var written = "";
/** The same order keeps its key, so that sending it again after a lost answer makes no second job. */
function keyOf(body) {
	const now = JSON.stringify(body);
	if (now !== written) key = freshKey();
	written = now;
	return key;
}
function Transfer() {
	const priority = useSignal("50");
	const wish = useSignal("");
	const fallbacks = useSignal("");
	const name = useSignal("");
	const sending = useSignal(false);
	const error = useSignal(null);
	const done = useSignal("");
	changes.stations.value;
	const known = stations.get(order.source.value)?.carrier ?? "";
	const send = async (event) => {
		event.preventDefault();
		const body = {
			source: order.source.value,
			destination: order.destination.value,
			priority: Number(priority.value),
			...order.carrier.value.trim() ? { carrier: order.carrier.value.trim() } : {},
			...wish.value ? { vehicle: wish.value.trim() } : {},
			...fallbacks.value.trim() ? { fallbacks: fallbacks.value.trim().split(/[\s,]+/) } : {},
			...name.value.trim() ? { job_id: name.value.trim() } : {}
		};
		sending.value = true;
		error.value = null;
		done.value = "";
		try {
			const job = await post("/jobs", body, { "Idempotency-Key": keyOf(body) });
			done.value = t("ordered", job.id);
			written = "";
			order.carrier.value = name.value = "";
		} catch (failure) {
			error.value = failure;
		} finally {
			sending.value = false;
		}
	};
	const wrong = error.value instanceof Refused ? error.value.field : "";
	return /* @__PURE__ */ a("form", {
		class: "card transfer",
		onSubmit: (event) => void send(event),
		children: [
			/* @__PURE__ */ a("h2", { children: t("new_transfer") }),
			/* @__PURE__ */ a(Place, {
				label: t("source"),
				value: order.source.value,
				choose: orderFrom,
				wrong: wrong === "source",
				vehicles: true
			}),
			/* @__PURE__ */ a(Place, {
				label: t("destination"),
				value: order.destination.value,
				choose: orderTo,
				wrong: wrong === "destination",
				partner: order.source.value
			}),
			/* @__PURE__ */ a("label", { children: [/* @__PURE__ */ a("span", { children: t("carrier") }), /* @__PURE__ */ a("input", {
				name: "carrier",
				value: order.carrier.value,
				maxLength: 64,
				placeholder: known || t("carrier_optional"),
				"aria-invalid": wrong === "carrier",
				autocomplete: "off",
				onInput: (event) => order.carrier.value = event.currentTarget.value
			})] }),
			/* @__PURE__ */ a("label", {
				class: "narrow",
				children: [/* @__PURE__ */ a("span", { children: t("priority") }), /* @__PURE__ */ a("input", {
					name: "priority",
					type: "number",
					min: "0",
					max: "99",
					required: true,
					value: priority.value,
					"aria-invalid": wrong === "priority",
					onInput: (event) => priority.value = event.currentTarget.value
				})]
			}),
			/* @__PURE__ */ a(Button, {
				needs: "POST /jobs",
				type: "submit",
				class: "primary",
				disabled: sending.value,
				children: sending.value ? t("ordering") : t("order")
			}),
			/* @__PURE__ */ a("details", {
				class: "more-order",
				children: [
					/* @__PURE__ */ a("summary", { children: t("more") }),
					/* @__PURE__ */ a("div", {
						class: "fields",
						children: [
							/* @__PURE__ */ a(Field, {
								label: t("vehicle"),
								name: "vehicle",
								value: wish,
								list: "order-vehicles",
								hint: t("any")
							}),
							/* @__PURE__ */ a(Field, {
								label: t("job_id"),
								name: "job_id",
								value: name,
								hint: t("given_here")
							}),
							/* @__PURE__ */ a(Field, {
								label: t("fallbacks_label"),
								name: "fallbacks",
								value: fallbacks,
								hint: t("none"),
								wide: true
							})
						]
					}),
					/* @__PURE__ */ a("datalist", {
						id: "order-vehicles",
						children: layout.value?.vehicles.map(({ id }) => /* @__PURE__ */ a("option", { value: id }, id))
					})
				]
			}),
			/* @__PURE__ */ a("div", {
				class: "outcome",
				children: error.value ? /* @__PURE__ */ a(Problem, { error: error.value }) : /* @__PURE__ */ a("span", {
					class: "done",
					role: "status",
					children: done.value
				})
			})
		]
	});
}
function Place(props) {
	const world = worldOf(layout.value, props.partner ?? "");
	const places = (layout.value?.stations ?? []).filter(({ kind }) => world === null || worldOfKind(kind) === world);
	const groups = [
		{
			name: t("ports"),
			stations: places.filter(({ kind }) => kind === "port")
		},
		{
			name: t("buffers"),
			stations: places.filter(({ kind }) => kind === "sbfl" || kind === "sbfr")
		},
		{
			name: t("agv_buffers"),
			stations: places.filter(({ kind }) => kind === "agv_buffer")
		}
	];
	const loaded = props.vehicles ? vehicleList.value.filter((vehicle) => vehicle.loaded) : [];
	const shown = (id) => {
		const now = stations.get(id);
		return now?.present ? `${id} · ${now.carrier ?? "■"}` : id;
	};
	return /* @__PURE__ */ a("label", { children: [/* @__PURE__ */ a("span", { children: props.label }), /* @__PURE__ */ a("select", {
		required: true,
		value: props.value,
		"aria-invalid": props.wrong,
		onChange: (event) => props.choose(event.currentTarget.value),
		children: [
			/* @__PURE__ */ a("option", {
				value: "",
				children: t("choose")
			}),
			groups.filter((group) => group.stations.length > 0).map((group) => /* @__PURE__ */ a("optgroup", {
				label: group.name,
				children: group.stations.map(({ id }) => /* @__PURE__ */ a("option", {
					value: id,
					children: shown(id)
				}, id))
			}, group.name)),
			loaded.length > 0 && /* @__PURE__ */ a("optgroup", {
				label: t("loaded_vehicles"),
				children: loaded.map(({ id, carrier }) => /* @__PURE__ */ a("option", {
					value: id,
					children: carrier ? `${id} · ${carrier}` : id
				}, id))
			})
		]
	})] });
}
// src/parts/WalkDetail.tsx
/** One audit walk: what was expected at each place, what was seen, what that comes to; and its end. */
var FINDINGS = [
	"not_seen",
	"differs",
	"moved",
	"agrees"
];
var TONES = {
	agrees: "good",
	differs: "bad",
	moved: "wait",
	not_seen: "calm"
};
var FULL = /* @__PURE__ */ new Set([
	"full",
	"1",
	"yes",
	"true",
	"y",
	"있음"
]);
var EMPTY = /* @__PURE__ */ new Set([
	"empty",
	"0",
	"no",
	"false",
	"n",
	"없음"
]);
/** So many sights the server takes at once. */
var AT_ONCE = 1e3;
/** What a file says was seen; lines without a word for it were not walked along. Raises Error: a line says something else. */
function sightsOf(text) {
	const rows = rowsOf(text);
	if (!rows.some((row) => "station" in row && "seen" in row)) throw new Error(t("walk_file_columns"));
	return rows.flatMap((row, i) => {
		const word = (row["seen"] ?? "").toLowerCase();
		if (!word || !row["station"]) return [];
		if (!FULL.has(word) && !EMPTY.has(word)) throw new Error(t("walk_file_word", i + 2, row["seen"] ?? ""));
		return [{
			station: row["station"],
			present: FULL.has(word),
			carrier: row["seen_carrier"] || null
		}];
	});
}
function WalkDetail({ walk }) {
	const only = useSignal("");
	const asking = useAsking();
	const { value } = useRead(`/walks/${walk.id}/places`, changes.walks.value, changes.stations.value);
	const places = value?.items ?? [];
	const open = walk.state === "open";
	const counts = Object.fromEntries(FINDINGS.map((name) => [name, places.filter(({ finding }) => finding === name).length]));
	return /* @__PURE__ */ a("div", {
		class: "walk",
		"data-walk": walk.id,
		children: [
			/* @__PURE__ */ a("div", {
				class: "padded stack",
				children: [
					/* @__PURE__ */ a("h2", {
						class: "sub",
						children: [
							"#",
							walk.id,
							" ",
							walk.reason,
							" · ",
							said$1(`walk_${walk.state}`)
						]
					}),
					/* @__PURE__ */ a("div", {
						class: "acts-row",
						role: "group",
						"aria-label": t("finding"),
						children: [FINDINGS.map((name) => /* @__PURE__ */ a("button", {
							type: "button",
							"aria-pressed": only.value === name,
							onClick: () => only.value = only.value === name ? "" : name,
							children: [
								t(`found_${name}`),
								" ",
								counts[name]
							]
						}, name)), /* @__PURE__ */ a(Files, {
							walk,
							places,
							asking
						})]
					}),
					/* @__PURE__ */ a(Told, { asking })
				]
			}),
			/* @__PURE__ */ a(Table, {
				label: t("places"),
				rows: places.filter(({ finding }) => !only.value || finding === only.value),
				keyOf: (row) => row.station,
				none: t("nothing_found"),
				columns: [
					{
						name: t("at_station"),
						by: (row) => row.station,
						of: (row) => /* @__PURE__ */ a(Name, { id: row.station })
					},
					{
						name: t("expected"),
						by: (row) => stands(row.now, row.now_carrier),
						of: (row) => stands(row.now, row.now_carrier)
					},
					{
						name: t("found"),
						by: (row) => stands(row.seen, row.seen_carrier),
						of: (row) => row.seen === null ? "" : stands(row.seen, row.seen_carrier)
					},
					{
						name: t("finding"),
						by: (row) => row.finding,
						of: (row) => /* @__PURE__ */ a("b", {
							class: TONES[row.finding] ?? "",
							children: said$1(`found_${row.finding}`)
						})
					},
					...open ? [{
						name: t("enter"),
						of: (row) => /* @__PURE__ */ a(Enter, {
							walk: walk.id,
							place: row,
							asking
						})
					}] : [{
						name: t("who"),
						of: (row) => row.by ?? ""
					}]
				]
			}),
			open && /* @__PURE__ */ a(Ends, {
				walk,
				doubtful: (counts["not_seen"] ?? 0) + (counts["moved"] ?? 0)
			})
		]
	});
}
/** What stands at a place, in words. */
function stands(present, carrier) {
	if (present === null) return t("unknown");
	return present ? carrier ?? t("unread") : t("empty");
}
function Enter({ walk, place, asking }) {
	const before = place.seen_carrier ?? place.now_carrier;
	const carrier = useSignal(before ?? "");
	const enter = (present) => {
		const written = carrier.value.trim() || null;
		const body = {
			present,
			carrier: present || written !== before ? written : null
		};
		asking.ask(() => call("PUT", `/walks/${walk}/places/${encodeURIComponent(place.station)}`, body), t("entered_place", place.station));
	};
	return /* @__PURE__ */ a("div", {
		class: "acts-row enter",
		children: [
			/* @__PURE__ */ a(Button, {
				needs: "PUT /walks/{walk}/places/{station}",
				"aria-pressed": place.seen === false,
				onClick: () => enter(false),
				children: t("empty")
			}),
			/* @__PURE__ */ a(Button, {
				needs: "PUT /walks/{walk}/places/{station}",
				"aria-pressed": place.seen === true,
				onClick: () => enter(true),
				children: t("full")
			}),
			/* @__PURE__ */ a("input", {
				"aria-label": `${t("carrier")} ${place.station}`,
				placeholder: t("unread"),
				value: carrier.value,
				onInput: (event) => carrier.value = event.currentTarget.value,
				onKeyDown: (event) => event.key === "Enter" && enter(true)
			})
		]
	});
}
/** The list to take along, and what came back in it. */
function Files({ walk, places, asking }) {
	const write = () => {
		const word = (present) => present === null ? "" : present ? "full" : "empty";
		save(csvOf([
			"station",
			"expected",
			"expected_carrier",
			"seen",
			"seen_carrier",
			"finding",
			"by",
			"at"
		], places.map((place) => ({
			...place,
			expected: word(place.now),
			expected_carrier: place.now_carrier,
			seen: word(place.seen)
		}))), `walk-${walk.id}.csv`);
	};
	const read = async (file) => {
		if (!file) return;
		let taken = 0;
		await asking.ask(async () => {
			const sights = sightsOf(await file.text());
			if (sights.length === 0) throw new Error(t("walk_file_nothing"));
			for (let i = 0; i < sights.length; i += AT_ONCE) await post(`/walks/${walk.id}/places`, { sights: sights.slice(i, i + AT_ONCE) });
			taken = sights.length;
		}, "");
		if (taken) asking.done.value = t("walk_file_read", taken);
	};
	return /* @__PURE__ */ a($, { children: [/* @__PURE__ */ a("button", {
		type: "button",
		onClick: write,
		children: t("save_csv")
	}), walk.state === "open" && refusal("POST /walks/{walk}/places") === "" && /* @__PURE__ */ a("label", {
		class: "file",
		children: [/* @__PURE__ */ a("span", { children: t("read_csv") }), /* @__PURE__ */ a("input", {
			type: "file",
			accept: ".csv,text/csv",
			"aria-label": t("read_csv"),
			onChange: (event) => {
				read(event.currentTarget.files?.[0]);
				event.currentTarget.value = "";
			}
		})]
	})] });
}
function Ends({ walk, doubtful }) {
	const path = `/walks/${walk.id}`;
	return /* @__PURE__ */ a("div", {
		class: "padded",
		children: [doubtful > 0 && /* @__PURE__ */ a("p", {
			class: "calm",
			children: t("walk_doubtful", doubtful)
		}), /* @__PURE__ */ a(Reasoned, { decisions: [{
			label: t(doubtful > 0 ? "accept_partial" : "accept"),
			needs: "POST /walks/{walk}/accept",
			bare: true,
			grave: true,
			does: () => post(`${path}/accept`, { partial: doubtful > 0 })
		}, {
			label: t("abandon"),
			needs: "POST /walks/{walk}/abandon",
			grave: true,
			does: (reason) => post(`${path}/abandon`, { reason })
		}] })]
	});
}
// src/parts/Walks.tsx
/** Audit walks along places after an outage: begun, entered at a place or from a file, compared, taken for true by a named person. */
function Walks() {
	const chosen = useSignal(null);
	const { value } = useRead("/walks/history?limit=200", changes.walks.value);
	const id = chosen.value ?? value?.items.find(({ state }) => state === "open")?.id ?? null;
	const walk = value?.items.find((one) => one.id === id);
	return /* @__PURE__ */ a("section", {
		class: "room",
		"aria-label": t("walks"),
		children: [/* @__PURE__ */ a("div", {
			class: "head",
			children: /* @__PURE__ */ a("h2", { children: t("walks") })
		}), /* @__PURE__ */ a("div", {
			class: "split walks",
			children: [/* @__PURE__ */ a("div", { children: [/* @__PURE__ */ a(Begin, { begun: (number) => chosen.value = number }), /* @__PURE__ */ a(Table, {
				label: t("walks"),
				rows: value?.items,
				keyOf: (row) => String(row.id),
				pick: (row) => chosen.value = row.id,
				chosen: String(id),
				none: t("no_walks"),
				columns: [
					{
						name: "#",
						by: (row) => row.id,
						of: (row) => row.id,
						number: true
					},
					{
						name: t("reason"),
						by: (row) => row.reason,
						of: (row) => /* @__PURE__ */ a("button", {
							type: "button",
							class: "text",
							onClick: () => chosen.value = row.id,
							children: row.reason
						})
					},
					{
						name: t("state"),
						by: (row) => row.state,
						of: (row) => /* @__PURE__ */ a("span", {
							class: row.state === "open" ? "wait" : "",
							children: said$1(`walk_${row.state}`)
						})
					},
					{
						name: t("entered"),
						by: (row) => row.entered,
						of: (row) => `${row.entered} / ${row.places}`,
						number: true
					},
					{
						name: t("begun"),
						by: (row) => row.started,
						of: (row) => `${moment$1(row.started)} · ${row.actor}`
					}
				]
			})] }), walk ? /* @__PURE__ */ a(WalkDetail, { walk }, walk.id) : /* @__PURE__ */ a("p", {
				class: "nothing",
				children: t("choose_walk")
			})]
		})]
	});
}
/** Along every side buffer, or along the stations that are named. */
function Begin({ begun }) {
	const [reason, stations] = [useSignal(""), useSignal("")];
	const asking = useAsking();
	const send = async (event) => {
		event.preventDefault();
		const names = stations.value.split(/[\s,]+/).filter(Boolean);
		if (await asking.ask(async () => {
			begun((await post("/walks", {
				reason: reason.value.trim(),
				stations: names
			})).id);
		})) reason.value = stations.value = "";
	};
	return /* @__PURE__ */ a("form", {
		class: "stack padded",
		"aria-label": t("begin_walk"),
		onSubmit: (event) => void send(event),
		children: [
			/* @__PURE__ */ a("h2", {
				class: "sub",
				children: t("begin_walk")
			}),
			/* @__PURE__ */ a("div", {
				class: "fields",
				children: [/* @__PURE__ */ a(Field, {
					label: t("reason"),
					name: "reason",
					value: reason,
					required: true
				}), /* @__PURE__ */ a(Field, {
					label: t("stations"),
					name: "stations",
					value: stations,
					hint: t("all_buffers")
				})]
			}),
			/* @__PURE__ */ a("div", {
				class: "acts-row",
				children: /* @__PURE__ */ a(Button, {
					needs: "POST /walks",
					type: "submit",
					disabled: asking.busy.value,
					children: t("begin_walk")
				})
			}),
			/* @__PURE__ */ a(Told, { asking })
		]
	});
}
// src/parts/Webhooks.tsx
/** Webhooks: who is told of events by HTTP, how far each is, what was tried; paused, tried, told again, given another secret. */
/** Asked so often, s. */
var EVERY = 3;
var tone = (state) => state === "active" ? "good" : state === "failed" ? "bad" : "wait";
function Webhooks() {
	const why = refusal("GET /webhooks");
	const chosen = useSignal(null);
	const again = useSignal(0);
	const { value } = useRead(why ? null : "/webhooks", again.value, Math.floor(tick.value / EVERY));
	const webhook = value?.items.find(({ id }) => id === chosen.value);
	return /* @__PURE__ */ a("section", {
		class: "room",
		"aria-label": t("webhooks"),
		children: [/* @__PURE__ */ a("div", {
			class: "head",
			children: /* @__PURE__ */ a("h2", { children: t("webhooks") })
		}), why ? /* @__PURE__ */ a("p", {
			class: "nothing",
			children: why
		}) : /* @__PURE__ */ a("div", {
			class: "split",
			children: [/* @__PURE__ */ a(Table, {
				label: t("webhooks"),
				rows: value?.items,
				keyOf: (row) => String(row.id),
				pick: (row) => chosen.value = row.id,
				chosen: String(chosen.value),
				none: t("no_webhooks"),
				columns: [
					{
						name: "#",
						by: (row) => row.id,
						of: (row) => row.id,
						number: true
					},
					{
						name: "URL",
						by: (row) => row.url,
						of: (row) => /* @__PURE__ */ a("button", {
							type: "button",
							class: "text",
							onClick: () => chosen.value = row.id,
							children: row.url
						})
					},
					{
						name: t("state"),
						by: (row) => row.state,
						of: (row) => /* @__PURE__ */ a("span", {
							class: tone(row.state),
							children: said$1(`hook_${row.state}`)
						})
					},
					{
						name: t("behind"),
						by: (row) => row.behind,
						of: (row) => row.behind,
						number: true
					},
					{
						name: t("delivered"),
						by: (row) => row.delivered,
						of: (row) => row.delivered,
						number: true
					},
					{
						name: t("failing_since"),
						by: (row) => row.failing,
						of: (row) => row.failing ? moment$1(row.failing) : ""
					}
				]
			}), /* @__PURE__ */ a("div", { children: [webhook && /* @__PURE__ */ a(Detail, {
				webhook,
				after: () => again.value++
			}, webhook.id), /* @__PURE__ */ a(Subscribe, { after: () => again.value++ })] })]
		})]
	});
}
function Detail({ webhook, after }) {
	const path = `/webhooks/${webhook.id}`;
	const from = useSignal("");
	const secret = useSignal("");
	const asking = useAsking();
	const round = useSignal(0);
	const { value } = useRead(`${path}/deliveries?limit=20`, round.value, webhook.delivered, webhook.attempts);
	const ask = async (what, words) => {
		await asking.ask(what, words);
		round.value++;
		after();
	};
	const ping = () => ask(async () => {
		const tried = await post(`${path}/ping`);
		if (!tried.taken) throw new Error(tried.error);
	}, t("pinged"));
	const renew = () => ask(async () => {
		secret.value = (await post(`${path}/secret`, {})).secret;
	}, t("both_sign"));
	const active = webhook.state === "active";
	return /* @__PURE__ */ a("section", {
		class: "stack padded",
		"data-webhook": webhook.id,
		"aria-label": `#${webhook.id}`,
		children: [
			/* @__PURE__ */ a("h2", {
				class: "sub",
				children: [
					"#",
					webhook.id,
					" ",
					webhook.note
				]
			}),
			(webhook.reason || webhook.error) && /* @__PURE__ */ a("p", {
				class: "note held",
				children: tell(webhook.reason || webhook.error)
			}),
			/* @__PURE__ */ a("dl", {
				class: "facts",
				children: [/* @__PURE__ */ a(Fact, {
					name: t("events"),
					children: webhook.events.length ? webhook.events.map(happening).join(", ") : t("all")
				}), /* @__PURE__ */ a(Fact, {
					name: t("told_up_to"),
					children: ["#", webhook.position]
				})]
			}),
			/* @__PURE__ */ a("div", {
				class: "acts-row",
				children: [
					/* @__PURE__ */ a(Button, {
						needs: "PATCH /webhooks/{webhook}",
						onClick: () => void ask(() => call("PATCH", path, { active: !active })),
						children: t(active ? "pause" : "resume")
					}),
					/* @__PURE__ */ a(Button, {
						needs: "POST /webhooks/{webhook}/ping",
						disabled: asking.busy.value,
						onClick: () => void ping(),
						children: t("ping")
					}),
					/* @__PURE__ */ a(Sure, {
						needs: "POST /webhooks/{webhook}/secret",
						label: t("new_secret"),
						does: () => void renew()
					}),
					/* @__PURE__ */ a(Sure, {
						needs: "DELETE /webhooks/{webhook}",
						label: t("remove"),
						does: () => void ask(() => call("DELETE", path))
					})
				]
			}),
			/* @__PURE__ */ a("div", {
				class: "fields",
				children: [/* @__PURE__ */ a(Field, {
					label: t("replay_after"),
					name: "after",
					type: "number",
					min: 0,
					value: from
				}), /* @__PURE__ */ a("div", {
					class: "acts-row",
					children: /* @__PURE__ */ a(Sure, {
						needs: "POST /webhooks/{webhook}/replay",
						label: t("replay"),
						disabled: from.value === "",
						does: () => void ask(() => post(`${path}/replay`, { after: Number(from.value) }))
					})
				})]
			}),
			/* @__PURE__ */ a(Told, { asking }),
			/* @__PURE__ */ a(Once, {
				label: t("secret"),
				value: secret
			}),
			/* @__PURE__ */ a("table", {
				class: "bits",
				"aria-label": t("deliveries"),
				children: /* @__PURE__ */ a("tbody", { children: value?.items.map((one) => /* @__PURE__ */ a("tr", { children: [
					/* @__PURE__ */ a("th", { children: moment$1(one.at) }),
					/* @__PURE__ */ a("td", {
						class: one.taken ? "good" : "bad",
						children: one.status ?? "–"
					}),
					/* @__PURE__ */ a("td", { children: [
						happening(one.event),
						" ",
						one.seq !== null && `#${one.seq}`,
						" · ",
						one.seconds.toFixed(2),
						" s ",
						one.error && `· ${tell(one.error)}`
					] })
				] }, one.number)) })
			})
		]
	});
}
function Subscribe({ after }) {
	const [url, events, note, from] = [
		useSignal(""),
		useSignal(""),
		useSignal(""),
		useSignal("")
	];
	const secret = useSignal("");
	const asking = useAsking();
	const send = async (event) => {
		event.preventDefault();
		const body = {
			url: url.value.trim(),
			events: events.value.split(/[\s,]+/).filter(Boolean),
			note: note.value.trim(),
			...from.value ? { after: Number(from.value) } : {}
		};
		if (!await asking.ask(async () => {
			secret.value = (await post("/webhooks", body)).secret;
		}, "")) return;
		url.value = events.value = note.value = from.value = "";
		after();
	};
	return /* @__PURE__ */ a("form", {
		class: "stack padded",
		"aria-label": t("subscribe"),
		onSubmit: (event) => void send(event),
		children: [
			/* @__PURE__ */ a("h2", {
				class: "sub",
				children: t("subscribe")
			}),
			/* @__PURE__ */ a("div", {
				class: "fields",
				children: [
					/* @__PURE__ */ a(Field, {
						label: "URL",
						name: "url",
						value: url,
						required: true,
						wide: true
					}),
					/* @__PURE__ */ a(Field, {
						label: t("events"),
						name: "events",
						value: events,
						hint: t("all")
					}),
					/* @__PURE__ */ a(Field, {
						label: t("begin_after"),
						name: "after",
						type: "number",
						min: 0,
						value: from,
						hint: t("from_now")
					}),
					/* @__PURE__ */ a(Field, {
						label: t("note"),
						name: "note",
						value: note,
						wide: true
					})
				]
			}),
			/* @__PURE__ */ a("div", {
				class: "acts-row",
				children: /* @__PURE__ */ a(Button, {
					needs: "POST /webhooks",
					type: "submit",
					disabled: asking.busy.value,
					children: t("subscribe")
				})
			}),
			/* @__PURE__ */ a(Told, { asking }),
			/* @__PURE__ */ a(Once, {
				label: t("secret"),
				value: secret
			})
		]
	});
}
// src/parts/App.tsx
function App() {
	const pick = selected.value;
	if (inPast.value || room$1.value === "playback") return /* @__PURE__ */ a(Past, {});
	return /* @__PURE__ */ a("div", {
		class: away$1.value ? "page old" : "page",
		children: [
			/* @__PURE__ */ a(Header, {}),
			/* @__PURE__ */ a("div", { children: [/* @__PURE__ */ a("div", {
				class: "top",
				children: [/* @__PURE__ */ a(Rooms, {}), /* @__PURE__ */ a(OpenOrder, {})]
			}), /* @__PURE__ */ a(Away, {})] }),
			/* @__PURE__ */ a("main", { children: [/* @__PURE__ */ a("section", {
				class: "left",
				children: room$1.value === "map" ? /* @__PURE__ */ a(Plan, {}) : /* @__PURE__ */ a(Room, {})
			}), /* @__PURE__ */ a("aside", {
				id: "ordering",
				class: pick ? room$1.value === "map" ? "telling" : "telling alone" : room$1.value === "map" ? "" : ordering.value ? "spare open" : "spare",
				children: [
					/* @__PURE__ */ a(CloseOrder, {}),
					/* @__PURE__ */ a(Transfer, {}),
					pick?.kind === "vehicle" && /* @__PURE__ */ a(VehiclePanel, { id: pick.id }, pick.id),
					pick?.kind === "station" && /* @__PURE__ */ a(StationPanel, { id: pick.id }, pick.id),
					pick?.kind === "device" && /* @__PURE__ */ a(DevicePanel, { id: pick.id }, pick.id),
					pick?.kind === "drive" && /* @__PURE__ */ a(DrivePanel, { id: pick.id }, pick.id),
					pick?.kind === "job" && /* @__PURE__ */ a(JobPanel, { id: pick.id }, pick.id),
					/* @__PURE__ */ a(Jobs, {})
				]
			})] }),
			asked$2.value && /* @__PURE__ */ a(LogIn, {}),
			/* @__PURE__ */ a(Barred, {})
		]
	});
}
/** What was: nothing on it can be commanded. */
function Past() {
	const pick = selected.value;
	return /* @__PURE__ */ a("div", {
		class: "page past",
		children: [
			/* @__PURE__ */ a(Header, {}),
			/* @__PURE__ */ a(Rooms, {}),
			/* @__PURE__ */ a("main", { children: [/* @__PURE__ */ a("section", {
				class: "left",
				children: /* @__PURE__ */ a(Playback, {})
			}), /* @__PURE__ */ a("aside", {
				class: pick ? "telling" : "",
				children: [
					pick && /* @__PURE__ */ a(PastPanel, { pick }, `${pick.kind} ${pick.id}`),
					/* @__PURE__ */ a(PastEvents, {}),
					/* @__PURE__ */ a(Jobs, {})
				]
			})] }),
			asked$2.value && /* @__PURE__ */ a(LogIn, {}),
			/* @__PURE__ */ a(Barred, {})
		]
	});
}
function Plan() {
	return /* @__PURE__ */ a("div", {
		class: "plan",
		children: [
			/* @__PURE__ */ a(VehicleStrip, {}),
			/* @__PURE__ */ a("div", {
				class: "stage",
				children: [/* @__PURE__ */ a(Circles, {}), /* @__PURE__ */ a(TrackMap, {})]
			}),
			/* @__PURE__ */ a(Below, {})
		]
	});
}
/** Closing track is best done on the map. */
function Closing() {
	return /* @__PURE__ */ a("div", {
		class: "plan closing",
		children: [/* @__PURE__ */ a("div", {
			class: "stage",
			children: [/* @__PURE__ */ a(Circles, {}), /* @__PURE__ */ a(TrackMap, {})]
		}), /* @__PURE__ */ a(Closures, {})]
	});
}
/** Hoists that wait for each other: nothing else matters as much. */
function Circles() {
	const now = controller.value;
	if (!now?.circles?.length) return null;
	return /* @__PURE__ */ a("div", {
		class: "banner",
		role: "alert",
		children: [
			/* @__PURE__ */ a("b", { children: t("circle") }),
			/* @__PURE__ */ a("span", { children: now.circles.map(tell).join(" · ") }),
			/* @__PURE__ */ a("small", {
				class: "calm",
				children: t("circles_counted", now.circles_found, now.circles_resolved)
			})
		]
	});
}
function Room() {
	switch (room$1.value) {
		case "vehicles": return /* @__PURE__ */ a(Vehicles, {});
		case "jobs": return /* @__PURE__ */ a(JobRoom, {});
		case "alarms": return /* @__PURE__ */ a(Alarms, {});
		case "closures": return /* @__PURE__ */ a(Closing, {});
		case "stations": return /* @__PURE__ */ a(Stations, {});
		case "walks": return /* @__PURE__ */ a(Walks, {});
		case "access": return /* @__PURE__ */ a(Staff, {});
		case "webhooks": return /* @__PURE__ */ a(Webhooks, {});
		case "audit": return /* @__PURE__ */ a(Audit, {});
		case "teaching": return /* @__PURE__ */ a(Teaching, {});
		case "statistics": return /* @__PURE__ */ a(Statistics, {});
		case "layouts": return /* @__PURE__ */ a(Layouts, {});
		default: return null;
	}
}
// src/main.tsx
begin$3();
speak(language.value);
begin$4();
begin$2();
begin$5();
Q(/* @__PURE__ */ a(App, {}), document.getElementById("page"));
